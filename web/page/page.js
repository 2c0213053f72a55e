// SPDX-License-Identifier: GPL-3.0-or-later
// Starts the program on the page, and stands between it and the browser: keys, clipboard, files.
'use strict';

const canvas = document.getElementById('canvas');
const say = (text, ...more) => {
  document.getElementById('status').replaceChildren(text, ...more);
  document.getElementById('progress').hidden = true;
  document.getElementById('start').style.display = 'flex';
};

// Threads share memory on isolated pages only. Where the server does not send the headers, a service worker adds them.
async function isIsolated() {
  if (crossOriginIsolated) return true;
  if (!('serviceWorker' in navigator) || sessionStorage.getItem('isolated')) return false;
  await navigator.serviceWorker.register('isolation.js');
  await navigator.serviceWorker.ready;
  sessionStorage.setItem('isolated', '1');
  location.reload();
  return new Promise(() => {});
}

const linkTo = (href, textContent, target = '_self') =>
    Object.assign(document.createElement('a'), {href, textContent, target});

// Within another page, some browsers isolate this one only if that one is isolated.
function sayNotIsolated() {
  const isWithin = self !== top;
  say('This browser does not let the page use threads, which Mesecina needs. ',
      isWithin ? linkTo(location.href, 'Open it in a page of its own.', '_blank') : '');
}

// A session in an address, as #s=..., is compressed and written in the letters that addresses may have.
const linkHead = '#s=';
const longestLink = 30000;
const throughStream = (bytes, stream) => new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer();

async function sessionOfLink(letters) {
  try {
    const bytes = atob(letters.replaceAll('-', '+').replaceAll('_', '/'));
    const packed = Uint8Array.from(bytes, byte => byte.charCodeAt(0));
    return new Uint8Array(await throughStream(packed, new DecompressionStream('deflate')));
  } catch {
    throw Error('the session in the link is damaged; a link must be copied whole');
  }
}

// The name of the file that was shared, without its extension.
function titleOf(session) {
  try {
    const {title} = JSON.parse(new TextDecoder().decode(session));
    return title.replaceAll('/', '-').replace(/(?<=.)\.[^.]*$/, '') || 'shared';
  } catch {
    return 'shared';
  }
}

// Copies a link, and tells the program (session_link.cpp) what became of it: 0 for copied; 1 if the clipboard refused
// it, so that it became the address of the page; 2 if it is too long.
async function share(session, call, answer) {
  const packed = new Uint8Array(await throughStream(session, new CompressionStream('deflate')));
  const head = location.origin + location.pathname + linkHead;
  const length = head.length + Math.ceil(packed.length * 4 / 3);
  const finish = kind => _mes_set_shared(call, answer, kind, length, longestLink);
  if (length > longestLink) return finish(2);
  const letters = btoa(String.fromCharCode(...packed));
  const link = head + letters.replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
  try {
    await navigator.clipboard.writeText(link);
    finish(0);
  } catch {
    history.replaceState(null, '', link);
    finish(1);
  }
}

// The file to open: #s=... has a session, ?open=crust.json names a file of this site, and the page of a lesson names
// its lesson, which is presented. So is that of ?open=crust.json&present. Null if there is none.
async function fileOfAddress() {
  if (location.hash.startsWith(linkHead)) {
    const bytes = await sessionOfLink(location.hash.slice(linkHead.length));
    return {path: `/files/${titleOf(bytes)}.json`, bytes};
  }
  const wanted = new URLSearchParams(location.search);
  const lesson = document.querySelector('meta[name=lesson]')?.content;
  const name = wanted.get('open') ?? lesson;
  if (!name) return null;
  const address = new URL(name, location.href);
  if (address.origin !== location.origin) throw Error('only files of this site are opened');
  const answer = await fetch(address);
  if (!answer.ok) throw Error(`${name} cannot be read (${answer.status})`);
  const leaf = decodeURIComponent(address.pathname.split('/').pop());
  const presents = wanted.has('present') || name === lesson;
  return {path: '/files/' + leaf, bytes: new Uint8Array(await answer.arrayBuffer()), presents};
}

async function start() {
  if (!await isIsolated()) return sayNotIsolated();
  sessionStorage.removeItem('isolated');
  // The program gets this context: one with its own attributes would blend the drawing with the page. Where the picture
  // is not preserved, Chromium clears it after the first copy into it, and the copy with it.
  const attributes = {alpha: false, antialias: false, depth: false, stencil: false, preserveDrawingBuffer: true};
  if (!canvas.getContext('webgl2', attributes))
    return say('This browser has no WebGL 2, which Mesecina needs.');
  const progress = document.getElementById('progress');
  const opened = await fileOfAddress();
  await home.open();
  window.Module = {
    canvas,
    arguments: opened ? [opened.path, ...(opened.presents ? ['--present'] : [])] : [],
    setStatus(text) {
      const found = /\((\d+)\/(\d+)\)/.exec(text);
      if (found) progress.value = found[1] / found[2];
    },
    preRun: [() => {
      ENV.HOME = '/home';
      FS.mkdirTree('/home');
      FS.mkdirTree('/files');
      if (opened) FS.writeFile(opened.path, opened.bytes);
      home.begin();
      watchFiles();
      GLFW.onMouseWheel = turnWheel;
    }],
    onAbort: reason => say('Mesecina has stopped: ' + reason),
    postRun: [() => {
      document.getElementById('start').style.display = 'none';
      addEventListener('resize', fit);
      fit();
      addEventListener('visibilitychange', () => { if (document.hidden) _mes_keep(); });
      addEventListener('pagehide', () => _mes_keep());
    }],
  };
  const program = document.createElement('script');
  program.src = 'mesecina.js';
  program.onerror = () => say('mesecina.js cannot be loaded.');
  document.body.append(program);
}

function fit() {
  Module.setCanvasSize(innerWidth, innerHeight);
}

// Keys. GLFW hears them after this listener. Those that the browser has no better use for are the program's.
addEventListener('keydown', event => {
  const isCommand = event.ctrlKey || event.metaKey;
  // The program asks for the text at once, but a page gets it from the event "paste" only, which comes next.
  if (isCommand && event.code === 'KeyV' && event.isTrusted) {
    event.stopImmediatePropagation();
    return;
  }
  const isForBrowser = event.key === 'F5' || event.key === 'F12' || (isCommand && /^[cxvrtwn]$/i.test(event.key));
  const isText = event.key.length === 1 && !isCommand && !event.altKey;
  if (!isText && !isForBrowser) event.preventDefault();
}, true);
addEventListener('paste', event => {
  globalThis.pastedText = event.clipboardData.getData('text/plain');
  dispatchEvent(new KeyboardEvent('keydown', {keyCode: 86, code: 'KeyV', key: 'v', ctrlKey: true}));
}, true);

// The GLFW of emscripten knows whole steps of the wheel only, though touchpads and fingers turn it a little at a time.
// A touchpad reports two fingers that part as a wheel with Ctrl.
function turnWheel(event) {
  if (event.type !== 'wheel' || event.target !== canvas) return;
  event.preventDefault();
  const inStep = event.ctrlKey && event.deltaMode === 0 ? 20 : [100, 3, 1][event.deltaMode];
  const {scrollFunc, id} = GLFW.active;
  if (scrollFunc) getWasmTableEntry(scrollFunc)(id, -event.deltaX / inStep, -event.deltaY / inStep);
}

// A drag goes on outside the window.
canvas.addEventListener('pointerdown', event => canvas.setPointerCapture(event.pointerId));
addEventListener('beforeunload', event => { if (document.title.startsWith('* ')) event.preventDefault(); });
addEventListener('hashchange', () => { if (location.hash.startsWith(linkHead)) location.reload(); });
addEventListener('contextmenu', event => event.preventDefault());

// The file that the user chooses in the dialog of the browser is copied to /files. Of the answers 0 is none yet, 1 a
// file and 2 none at all.
let answer = 0;
let answeredName = '';
function askFile(extensions) {
  answer = 0;
  const field = document.createElement('input');
  field.type = 'file';
  field.accept = extensions;
  field.onchange = async () => {
    answeredName = field.files[0].name;
    FS.writeFile('/files/' + answeredName, new Uint8Array(await field.files[0].arrayBuffer()));
    answer = 1;
  };
  field.oncancel = () => { answer = 2; };
  field.click();
}
function answerFile(name, size) {
  if (answer === 1) stringToUTF8(answeredName, name, size);
  return answer;
}

// Files are written beside their target and renamed, so a name that appears outside /home is a complete file.
function watchFiles() {
  const rename = FS.rename;
  FS.rename = (from, to) => {
    rename.call(FS, from, to);
    const target = FS.lookupPath(to).path;
    if (target.startsWith('/home/') || target.startsWith('/tmp/')) return;
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([FS.readFile(target)]));
    link.download = target.split('/').pop();
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  };
}

start().catch(error => say(`Mesecina cannot start: ${error.message}. `,
                           location.search || location.hash ? linkTo(location.pathname, 'Start without it.') : ''));
