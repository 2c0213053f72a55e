// SPDX-License-Identifier: GPL-3.0-or-later
// Fingers. One is the left button of a mouse, and thus the tool. Two move and enlarge the drawing, as the middle button
// and the wheel do, or scroll a panel; a short tap of two is the right button.
'use strict';

{
  const kHold = 120;     // ms until a finger that rests presses the button
  const kTap = 300;      // ms that a tap of two fingers takes at most
  const kSlip = 8;       // px that a finger may slip without moving
  const kStep = 1.2;     // the wheel enlarges by this factor in a step (app/canvas/canvas.cpp)
  const kStepHeight = 75;  // px of a panel that a step of the wheel scrolls
  const canvas = document.getElementById('canvas');

  // What the fingers do: nothing; the first waits for others; it is the tool; two move the view; the last are leaving.
  let state = 'none';
  let start = null;  // where and when the present state began
  let last = null;   // where the fingers were at the last event
  let timer = 0;

  const mouse = (type, {x, y}, button = 0) => canvas.dispatchEvent(
      new MouseEvent(type, {clientX: x, clientY: y, button, bubbles: true, cancelable: true}));
  const wheel = ({x, y}, steps) => canvas.dispatchEvent(
      new WheelEvent('wheel', {clientX: x, clientY: y, deltaY: -100 * steps, bubbles: true, cancelable: true}));
  const length = (from, to) => Math.hypot(to.x - from.x, to.y - from.y);

  // The middle of the first two fingers and their distance.
  function placeOf(touches) {
    const [a, b = a] = Array.from(touches, touch => ({x: touch.clientX, y: touch.clientY}));
    return {x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, width: length(a, b), time: performance.now()};
  }

  function press() {
    clearTimeout(timer);
    mouse('mousedown', start);
    state = 'tool';
  }

  function begin(touches) {
    const place = placeOf(touches);
    if (touches.length === 1 && state === 'none') {
      state = 'waiting';
      start = last = place;
      mouse('mousemove', place);
      timer = setTimeout(press, kHold);
    } else if (touches.length > 1 && ['none', 'waiting', 'tool'].includes(state)) {
      clearTimeout(timer);
      // The tool takes back what the first finger did.
      if (state === 'tool') {
        for (const type of ['keydown', 'keyup'])
          dispatchEvent(new KeyboardEvent(type, {key: 'Escape', code: 'Escape', keyCode: 27}));
        mouse('mouseup', last);
      }
      state = _mes_is_on_panel(place.x, place.y) ? 'scrolling' : 'viewing';
      start = last = place;
      mouse('mousemove', place);
      if (state === 'viewing') mouse('mousedown', place, 1);
    }
  }

  function move(touches) {
    const place = placeOf(touches);
    if (state === 'waiting' && length(start, place) > kSlip) press();
    if (state === 'tool') {
      mouse('mousemove', place);
    } else if (touches.length > 1 && state === 'viewing') {
      mouse('mousemove', place);
      if (place.width > 0 && last.width > 0) wheel(place, Math.log(place.width / last.width) / Math.log(kStep));
    } else if (touches.length > 1 && state === 'scrolling') {
      wheel(place, (place.y - last.y) / kStepHeight);
    }
    if (state !== 'leaving') last = place;
  }

  function end(touches) {
    if (state === 'waiting') press();
    const isTap = performance.now() - start.time < kTap && length(start, last) <= kSlip &&
                  Math.abs(last.width - start.width) <= kSlip;
    if (state === 'tool') mouse('mouseup', last);
    if (state === 'viewing') mouse('mouseup', last, 1);
    if (state === 'viewing' && isTap) {
      for (const type of ['mousedown', 'mouseup']) mouse(type, last, 2);
    } else if (state !== 'leaving') {
      // Nothing is below a finger that is gone.
      mouse('mousemove', {x: -100, y: -100});
      mouse('mouseleave', last);
    }
    state = touches.length ? 'leaving' : 'none';
  }

  // GLFW hears them after these listeners, and would take the first finger for a mouse.
  const hear = (type, act) => addEventListener(type, event => {
    if (event.target !== canvas) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    if (window._mes_is_on_panel) act(event.targetTouches);
  }, {capture: true, passive: false});
  hear('touchstart', begin);
  hear('touchmove', move);
  hear('touchend', end);
  hear('touchcancel', end);
}
