// @ts-check
/*
 * Checks what a pupil's page needs, and says in words what it found. Even a browser that is too old has to be able to say
 * so: this is no module, and uses nothing that came after 2012.
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
  var HOTSPOT = "Use another network: the hotspot of the teacher's computer or of a phone needs no internet.";

  var WITHOUT = "Without any connection, a replay plays: one file, which the teacher's page makes under Share.";

  /** @typedef {"good" | "fair" | "bad"} Mark */
  var SIGNS = { good: "✓", fair: "!", bad: "✗" };
  /** @type {Mark} */
  var worst = "good";
  var worksAtAll = true;

  /** @param {string} id */
  function byId(id) {
    return /** @type {HTMLElement} */ (document.getElementById(id));
  }

  /**
   * @param {Mark} mark
   * @param {string} text what was found
   * @param {string} [advice] what to do about it
   */
  function say(mark, text, advice) {
    var item = document.createElement("li");
    item.className = mark;
    var sign = document.createElement("b");
    sign.appendChild(document.createTextNode(SIGNS[mark]));
    item.appendChild(sign);
    item.appendChild(document.createTextNode(text));
    if (advice) {
      var more = document.createElement("p");
      more.appendChild(document.createTextNode(advice));
      item.appendChild(more);
    }
    byId("found").appendChild(item);
    if (mark === "bad") worksAtAll = false;
    if (worst === "good" || mark === "bad") worst = mark;
  }

  /** @param {string} text @param {boolean} [again] whether it can be tried again */
  function conclude(text, again) {
    var verdict = byId("verdict");
    verdict.className = worst;
    verdict.innerHTML = "";
    verdict.appendChild(document.createTextNode(text));
    if (!again) return;
    var button = document.createElement("button");
    button.appendChild(document.createTextNode("Try again"));
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
      whyNot("This browser makes no live connection (WebSocket).");
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

    /** @param {string} text */
    function send(text) {
      if (socket.readyState === 1) socket.send(text);
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
      say("good", "A live connection (WebSocket) comes about, after " + (new Date().getTime() - began) + " ms.");
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
        say("bad", "The connection was cut after " + (new Date().getTime() - began) + " ms.", "Something on the way ends it. " + HOTSPOT + " " + WITHOUT);
        conclude("Here a class does not work.", true);
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
        say("bad", known, "Use a current Chrome, Edge, Firefox or Safari.");
      } else if (answer.status === 200) {
        say(
          "bad",
          "No live connection (WebSocket) comes about, although pages do: something on the way, such as a school's web filter or proxy, lets none through.",
          HOTSPOT + " Or have whoever runs the network let WebSockets to " + location.host + " through; pages by https often pass where those by http do not. " + WITHOUT
        );
      } else if (answer.status) {
        say("bad", "The teacher's computer refuses the connection: " + answer.responseText);
      } else {
        say("bad", "The teacher's computer no longer answers.", "Is softrod still running, and the computer awake? " + HOTSPOT);
      }
      conclude("Here a class does not work.", true);
    });
  }

  /**
   * @param {(text: string) => void} send
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
    if (trip < 0) say("bad", "The connection is there, but no answer comes through it.", "Something on the way holds messages back. " + HOTSPOT);
    else if (trip > SLOW) say("fair", "The round trip takes " + trip + " ms: bodies follow a finger late.", "Go nearer to the access point, or use fewer devices at a time.");
    else say("good", "The round trip takes " + trip + " ms.");
    if (rate < 1) say("bad", "No moving pictures arrive.", "Something on the way holds messages back. " + HOTSPOT);
    else if (rate < JERKY) say("fair", "Only " + rate + " pictures a second arrive: motion jerks.", "Go nearer to the access point, or use fewer devices at a time.");
    else say("good", "Moving pictures arrive, " + rate + " a second.");
    // Whole numbers, since all of this can be forged anyway.
    send(JSON.stringify({ do: "checked", trip: Math.min(trip, 99999), rate: rate, works: worksAtAll, doubts: worst !== "good" }));
    setTimeout(function () {
      socket.close();
    }, 300);
    if (!worksAtAll) conclude("Here a class does not work.", true);
    else if (worst === "fair") conclude("A class works from here; read what is marked.", true);
    else conclude("All right: a class works from here.");
  }

  // ----------------------------------------------------------------------- one after the other
  byId("found").removeChild(/** @type {Element} */ (document.querySelector(".unless")));
  var page = new Date().getTime();
  ask(script.getAttribute("data-try") || "", function (answer) {
    if (answer.status === 200 && /javascript/.test(answer.getResponseHeader("Content-Type") || "")) {
      say("good", "Its scripts come, in " + (new Date().getTime() - page) + " ms.");
    } else {
      say("bad", "The scripts of the class's pages do not come.", "Something on the way blocks them. " + HOTSPOT);
    }
    if (draws()) say("good", "This browser can show a class.");
    else say("bad", "This browser cannot show a class: it is too old.", "Use a current Chrome, Edge, Firefox or Safari.");
    if (stores()) say("good", "This browser stores answers until they have arrived.");
    else say("fair", "This browser stores nothing: an answer that has not arrived is lost by a reload.", "Leave the private window, or allow the page to store data.");
    ask(REACH, function (now) {
      var apart = Math.abs(new Date().getTime() - new Date(now.getResponseHeader("Date") || NaN).getTime());
      if (apart > APART) say("fair", "Its clock and the teacher's differ by " + Math.round(apart / 60000) + " minutes.", "A class does not mind, but addresses with https may be refused.");
      else if (apart >= 0) say("good", "Its clock agrees with the teacher's.");
      connect();
    });
  });
})();
