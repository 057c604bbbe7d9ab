// @ts-check
/*
 * Checks what a pupil's page needs, and says in words what it found. Even a browser that is too old has to be able to say
 * so: this is no module, and uses nothing that came after 2012. Its texts are in attributes of its element, in the page's language.
 */
(function () {
  var script = /** @type {HTMLScriptElement} */ (document.currentScript || document.querySelector("script[data-try]"));
  /** As in `connection.js`. */
  var HURRY = Number(/** @type {any} */ (window).__softrodHurry) || 1;
  /** Milliseconds in which a connection has to come about. */
  var PATIENCE = 3000 / HURRY;
  /** Milliseconds for which pictures are counted then. */
  var COUNTED = 1500 / HURRY;
  /** Milliseconds of a round trip beyond which drags lag. */
  var SLOW = 250;
  /** Pictures a second below which motion jerks. */
  var JERKY = 20;
  /** Milliseconds by which two clocks may differ; the server's has a resolution of a second. */
  var APART = 60000;
  /** Where the server says whether it would take a connection. */
  var REACH = "reach";

  /** @typedef {"good" | "fair" | "bad"} Mark */
  var SIGNS = { good: "✓", fair: "!", bad: "✗" };
  /** @type {Mark} */
  var worst = "good";
  var worksAtAll = true;

  /**
   * A text of the page.
   *
   * @param {string} name of the attribute, after "data-"
   * @param {Record<string, string | number>} [values] what stands in its places
   */
  function text(name, values) {
    var said = script.getAttribute("data-" + name) || name;
    for (var place in values || {}) said = said.split("{" + place + "}").join(String(/** @type {any} */ (values)[place]));
    return said;
  }

  /** Several texts, one after the other. @param {string[]} names */
  function texts(names) {
    var said = [];
    for (var i = 0; i < names.length; i++) said.push(text(names[i]));
    return said.join(" ");
  }

  /** @param {string} id */
  function byId(id) {
    return /** @type {HTMLElement} */ (document.getElementById(id));
  }

  /**
   * @param {Mark} mark
   * @param {string} found what was found
   * @param {string} [advice] what to do about it
   */
  function note(mark, found, advice) {
    var item = document.createElement("li");
    item.className = mark;
    var sign = document.createElement("b");
    sign.appendChild(document.createTextNode(SIGNS[mark]));
    item.appendChild(sign);
    item.appendChild(document.createTextNode(found));
    if (advice) {
      var more = document.createElement("p");
      more.appendChild(document.createTextNode(advice));
      item.appendChild(more);
    }
    byId("found").appendChild(item);
    if (mark === "bad") worksAtAll = false;
    if (worst === "good" || mark === "bad") worst = mark;
  }

  /** @param {string} name of the text @param {boolean} [again] whether it can be tried again */
  function conclude(name, again) {
    var verdict = byId("verdict");
    verdict.className = worst;
    verdict.innerHTML = "";
    verdict.appendChild(document.createTextNode(text(name)));
    if (!again) return;
    var button = document.createElement("button");
    button.appendChild(document.createTextNode(text("again")));
    button.onclick = function () {
      location.reload();
    };
    document.body.appendChild(button);
  }

  /**
   * Asks the server for something, and hands on its answer; one with status 0 if none comes.
   *
   * @param {string} address
   * @param {(answer: XMLHttpRequest) => void} then
   */
  function ask(address, then) {
    var request = new XMLHttpRequest();
    request.open("GET", address);
    request.timeout = PATIENCE;
    // A cached answer would say nothing about the network.
    request.setRequestHeader("Cache-Control", "no-cache");
    if (address === REACH) request.setRequestHeader("X-Softrod-Origin", location.protocol + "//" + location.host);
    request.onloadend = function () {
      then(request);
    };
    request.send();
  }

  /** Whether the browser knows the language and the pictures of the class's pages. */
  function draws() {
    try {
      return "noModule" in script && !!document.createElement("canvas").getContext("2d");
    } catch (error) {
      return false;
    }
  }

  function stores() {
    try {
      localStorage.setItem("softrod-check", "1");
      localStorage.removeItem("softrod-check");
      return true;
    } catch (error) {
      return false;
    }
  }

  // ----------------------------------------------------------------------- the connection
  function connect() {
    var name = "";
    for (var i = 0; i < 32; i++) name += Math.floor(16 * Math.random()).toString(16);
    var folder = location.host + location.pathname.replace(/[^/]*$/, "");
    var room = /[?&](room=[A-Za-z]{0,4})(&|$)/.exec(location.search);
    var address = location.protocol.replace("http", "ws") + "//" + folder + "line/" + name + "?as=check" + (room ? "&" + room[1] : "");
    /** @type {WebSocket} */
    var socket;
    try {
      socket = new WebSocket(address);
    } catch (error) {
      whyNot(text("no-sockets"));
      return;
    }
    var began = new Date().getTime();
    var opened = false;
    var over = false;
    var pictures = 0;
    /** When the first picture came, and when the beat under way was sent. */
    var first = 0;
    var beaten = 0;
    /** @type {number[]} */
    var trips = [];

    /** @param {string} said */
    function send(said) {
      if (socket.readyState === 1) socket.send(said);
    }
    function beat() {
      beaten = new Date().getTime();
      // It asks for a sign of life, which is an empty batch.
      send("");
    }
    function finish() {
      if (over) return;
      over = true;
      if (!opened) {
        socket.close();
        whyNot("");
        return;
      }
      report(send, socket, trips, first ? pictures / ((new Date().getTime() - first) / 1000) : 0);
    }

    socket.binaryType = "arraybuffer";
    socket.onopen = function () {
      opened = true;
      note("good", text("connected", { ms: new Date().getTime() - began }));
      beat();
    };
    socket.onmessage = function (event) {
      var now = new Date().getTime();
      if (!event.data.byteLength) {
        trips.push(now - beaten);
        // One after the other: many at once would wait for each other.
        setTimeout(beat, 50);
      } else if (first) {
        pictures++;
      } else {
        first = now;
        setTimeout(finish, COUNTED);
      }
    };
    socket.onclose = function () {
      if (opened && !over) {
        over = true;
        note("bad", text("cut", { ms: new Date().getTime() - began }), texts(["ends", "hotspot", "without"]));
        conclude("bad", true);
      } else {
        finish();
      }
    };
    setTimeout(function () {
      if (!first) finish();
    }, PATIENCE);
  }

  /** There is no connection: is it the server or the way to it? @param {string} known */
  function whyNot(known) {
    ask(REACH, function (answer) {
      if (known) {
        note("bad", known, text("current"));
      } else if (answer.status === 200) {
        note("bad", text("blocked"), [text("hotspot"), text("let-through", { host: location.host }), text("without")].join(" "));
      } else if (answer.status) {
        note("bad", text("refused", { reason: answer.responseText }));
      } else {
        note("bad", text("silent"), texts(["awake", "hotspot"]));
      }
      conclude("bad", true);
    });
  }

  /**
   * @param {(said: string) => void} send
   * @param {WebSocket} socket
   * @param {number[]} trips ms
   * @param {number} rate pictures a second
   */
  function report(send, socket, trips, rate) {
    trips.sort(function (a, b) {
      return a - b;
    });
    var trip = trips.length ? trips[Math.floor(trips.length / 2)] : -1;
    rate = Math.round(rate);
    if (trip < 0) note("bad", text("no-answer"), texts(["holds", "hotspot"]));
    else if (trip > SLOW) note("fair", text("slow", { ms: trip }), text("nearer"));
    else note("good", text("trip", { ms: trip }));
    if (rate < 1) note("bad", text("no-pictures"), texts(["holds", "hotspot"]));
    else if (rate < JERKY) note("fair", text("jerks", { rate: rate }), text("nearer"));
    else note("good", text("pictures", { rate: rate }));
    // Whole numbers, since all of this can be forged anyway.
    send(JSON.stringify({ do: "checked", trip: Math.min(trip, 99999), rate: rate, works: worksAtAll, doubts: worst !== "good" }));
    setTimeout(function () {
      socket.close();
    }, 300);
    if (!worksAtAll) conclude("bad", true);
    else if (worst === "fair") conclude("fair", true);
    else conclude("good");
  }

  // ----------------------------------------------------------------------- one after the other
  byId("found").removeChild(/** @type {Element} */ (document.querySelector(".unless")));
  var page = new Date().getTime();
  ask(script.getAttribute("data-try") || "", function (answer) {
    if (answer.status === 200 && /javascript/.test(answer.getResponseHeader("Content-Type") || "")) {
      note("good", text("scripts", { ms: new Date().getTime() - page }));
    } else {
      note("bad", text("no-scripts"), texts(["blocks", "hotspot"]));
    }
    if (draws()) note("good", text("shows"));
    else note("bad", text("too-old"), text("current"));
    if (stores()) note("good", text("stores"));
    else note("fair", text("stores-not"), text("allow"));
    ask(REACH, function (now) {
      var apart = Math.abs(new Date().getTime() - new Date(now.getResponseHeader("Date") || NaN).getTime());
      if (apart > APART) note("fair", text("apart", { minutes: Math.round(apart / 60000) }), text("https"));
      else if (apart >= 0) note("good", text("clock"));
      connect();
    });
  });
})();
