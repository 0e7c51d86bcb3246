// A laboratory behind a WebSocket; reconnects when the connection is lost.
import type { Carry } from "./connection.ts";

const FIRST_WAIT = 250;
const LONGEST_WAIT = 4000;

export function overSocket(address: string): Carry {
  return (listener) => {
    let socket: WebSocket | null = null;
    let wait = FIRST_WAIT;
    const connect = () => {
      socket = new WebSocket(address);
      socket.binaryType = "arraybuffer";
      socket.onopen = () => {
        wait = FIRST_WAIT;
        listener.opened();
      };
      socket.onmessage = (event: MessageEvent<string | ArrayBuffer>) => listener.message(event.data);
      socket.onclose = (event) => {
        listener.closed(event.reason);
        setTimeout(connect, wait);
        wait = Math.min(LONGEST_WAIT, 2 * wait);
      };
    };
    connect();
    const place = new URL(address.replace(/^ws/, "http"));
    place.pathname = "/file";
    return {
      file: async (name) => {
        place.searchParams.set("name", name);
        const answer = await fetch(place);
        if (!answer.ok) throw new Error(`The file could not be had: ${answer.status}`);
        return answer.arrayBuffer();
      },
      send: (text) => socket?.readyState === WebSocket.OPEN && socket.send(text),
    };
  };
}

// The address of the laboratory that served this page.
export function socketAddress(page: Location): string {
  const token = new URLSearchParams(page.search).get("token") ?? "";
  const scheme = page.protocol === "https:" ? "wss:" : "ws:";
  return `${scheme}//${page.host}/live?token=${encodeURIComponent(token)}`;
}
