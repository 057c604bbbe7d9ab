// @ts-check
/** Why a page gets no connection. */

/**
 * Asks why the server refuses connections of this page: the browser does not show the answer of a WebSocket.
 *
 * @param {string} blocked what to say where pages come and WebSockets do not
 * @param {string} away what to say where the server does not answer
 */
export async function reasonOfRefusal(blocked, away) {
  try {
    const answer = await fetch("reach", { headers: { "X-Softrod-Origin": location.origin }, cache: "no-store" });
    return answer.ok ? blocked : await answer.text();
  } catch {
    return away;
  }
}
