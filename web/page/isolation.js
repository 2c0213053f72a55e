// SPDX-License-Identifier: GPL-3.0-or-later
// A service worker that adds the headers without which browsers share no memory between threads, for servers that do
// not send them. The first two isolate a page of its own, the third one within another page, where a browser knows it.
addEventListener('install', () => skipWaiting());
addEventListener('activate', event => event.waitUntil(clients.claim()));
addEventListener('fetch', event => {
  const request = event.request;
  if (request.cache === 'only-if-cached' && request.mode !== 'same-origin') return;
  event.respondWith(fetch(request).then(answer => {
    if (answer.status === 0) return answer;
    const headers = new Headers(answer.headers);
    headers.set('Cross-Origin-Opener-Policy', 'same-origin');
    headers.set('Cross-Origin-Embedder-Policy', 'require-corp');
    headers.set('Document-Isolation-Policy', 'isolate-and-require-corp');
    headers.set('Cross-Origin-Resource-Policy', 'cross-origin');
    return new Response(answer.body, {status: answer.status, statusText: answer.statusText, headers});
  }));
});
