// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the files below /home in the database of the browser, so that a page that is closed or killed loses neither
// settings nor unsaved work.
//
// A record is a piece of a file. Its key has the owner of the file, its path, and where the piece begins. Journals of
// unsaved work are owned by a page, which holds a lock of its own name as long as it lives; a page that starts takes
// over the journals of pages that are gone. All other files belong to every page, and a page tells the others when it
// changes one.
'use strict';

globalThis.home = (() => {
  const kInputOutputError = 29;
  const page = crypto.randomUUID();
  const others = new BroadcastChannel('mesecina files');
  const lengths = new Map();  // how much of each file is in the database
  let database = null;
  let pieces = [];  // of the files that the program begins with

  const isKept = path => path.startsWith('/home/');
  const ownerOf = path => path.includes('/autosave/') ? page : '';
  const nameOf = owner => 'mesecina page ' + owner;
  const piecesOf = path => IDBKeyRange.bound([ownerOf(path), path], [ownerOf(path), path, []]);
  const answer = request => new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });

  const contentOf = path => FS.analyzePath(path).exists ? FS.readFile(path) : null;
  const areEqual = (a, b) => a && b && a.length === b.length && a.every((byte, i) => byte === b[i]);

  // Changes are done in the order of these calls.
  function change(path, act) {
    if (!database) return;
    const transaction = database.transaction('files', 'readwrite', {durability: 'strict'});
    // The contents of the database are then unknown, so the next change writes the whole file.
    transaction.onabort = () => lengths.set(path, Infinity);
    act(transaction.objectStore('files'));
    transaction.commit();
  }

  function put(path) {
    const bytes = FS.readFile(path);
    lengths.set(path, bytes.length);
    change(path, files => {
      files.delete(piecesOf(path));
      files.put(bytes, [ownerOf(path), path, 0]);
    });
    if (!ownerOf(path)) others.postMessage({path, bytes});
  }

  function remove(path) {
    lengths.delete(path);
    change(path, files => files.delete(piecesOf(path)));
  }

  // Takes over the files of pages that are gone. Only one page does so at a time.
  async function takeOver() {
    await new Promise(resolve => {
      navigator.locks.request(nameOf(page), () => {
        resolve();
        return new Promise(() => {});
      });
    });
    const living = new Set((await navigator.locks.query()).held.map(lock => lock.name));
    const files = database.transaction('files', 'readwrite').objectStore('files');
    const [keys, values] = await Promise.all([answer(files.getAllKeys()), answer(files.getAll())]);
    keys.forEach(([owner, path, begin], i) => {
      if (owner && living.has(nameOf(owner))) return;
      // Two pages may have begun their journals in the same second.
      const name = owner ? path.replace(/[^/]*$/, leaf => leaf.replace('.', `-${owner}.`)) : path;
      pieces.push({path: name, begin, bytes: values[i]});
      if (!owner) return;
      files.delete([owner, path, begin]);
      files.put(values[i], [page, name, begin]);
    });
  }

  return {
    /// Reads the files. Without a database the program runs as well, and says that unsaved work is not protected.
    async open() {
      try {
        const request = indexedDB.open('mesecina', 1);
        request.onupgradeneeded = () => request.result.createObjectStore('files');
        database = await answer(request);
        await navigator.locks.request('mesecina takes over', takeOver);
      } catch (error) {
        console.warn('Files are not kept: ' + error.message);
        database = null;
      }
    },

    /// Gives the program its files, and follows their changes. Files are written beside their target and renamed.
    begin() {
      for (const {path, begin, bytes} of pieces) {
        FS.mkdirTree(path.slice(0, path.lastIndexOf('/')));
        const file = FS.open(path, begin === 0 ? 'w' : 'a');
        FS.write(file, bytes, 0, bytes.length, begin);
        FS.close(file);
        lengths.set(path, begin + bytes.length);
      }
      pieces = [];
      const rename = FS.rename;
      FS.rename = (from, to) => {
        const before = contentOf(to);
        rename.call(FS, from, to);
        if (lengths.has(from)) remove(from);
        const {path} = FS.lookupPath(to);
        if (isKept(path) && !areEqual(before, contentOf(to))) put(path);
      };
      const unlink = FS.unlink;
      FS.unlink = path => {
        unlink.call(FS, path);
        if (lengths.has(path)) remove(path);
      };
      others.onmessage = ({data: {path, bytes}}) => {
        FS.mkdirTree(path.slice(0, path.lastIndexOf('/')));
        FS.writeFile(path, bytes);
        lengths.set(path, bytes.length);
      };
    },

    /// What `fdatasync` does. The program calls it for journals only, to which it appends.
    sync({path, node}) {
      if (!isKept(path)) return 0;
      if (!database) return kInputOutputError;
      const begin = lengths.get(path) ?? 0;
      const end = node.usedBytes;
      if (begin === 0 || end < begin) {
        put(path);
      } else if (end > begin) {
        lengths.set(path, end);
        change(path, files => files.put(node.contents.slice(begin, end), [ownerOf(path), path, begin]));
      }
      return 0;
    },
  };
})();
