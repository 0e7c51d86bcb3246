// Icons of buttons as drawings of 16 by 16, because fonts do not all contain them.

const DRAWINGS = {
  play: "M4 2.5v11l9.5-5.5z",
  pause: "M4 2.5h3v11H4zM9 2.5h3v11H9z",
  start: "M3 2.5h2v11H3zM13.5 2.5v11L5.5 8z",
  end: "M11 2.5h2v11h-2zM2.5 2.5v11l8-5.5z",
  back: "M6.5 2 2 6l4.5 4V7.2h4.3a2.3 2.3 0 0 1 0 4.6H6v2h4.8a4.3 4.3 0 0 0 0-8.6H6.5z",
  over: "M9.5 2 14 6l-4.5 4V7.2H5.2a2.3 2.3 0 0 0 0 4.6H10v2H5.2a4.3 4.3 0 0 1 0-8.6h4.3z",
  into: "M7 2h2v7h3l-4 4.5L4 9h3zM3 14h10v1.5H3z",
  out: "M7 11.5h2v-7h3L8 .5l-4 4h3zM3 14h10v1.5H3z",
  continue: "M2 2.5v11L9 8zM10.5 8a2.75 2.75 0 1 0 5.5 0 2.75 2.75 0 1 0-5.5 0z",
  left: "M1.5 2.5h13v11h-13zM3 4h3v8H3zM7 4v8h6V4z",
  middle: "M1.5 2.5h13v11h-13zM3 4v8h1.5V4zM6 4h4v8H6zM11.5 4v8H13V4z",
  right: "M1.5 2.5h13v11h-13zM10 4h3v8h-3zM3 4v8h6V4z",
  wrap: "M1.5 2.5h13V4h-13zM1.5 6.5h10a2.7 2.7 0 0 1 0 5.4H9.5v1.8L6.6 11.2l2.9-2.5v1.7h2a1.2 1.2 0 0 0 0-2.4h-10zM1.5 11h3.2v1.5H1.5z",
  below: "M1.5 2.5h13v11h-13zM3 4v4h10V4zM3.5 11.5l3-2 3 1.5 3-2v1l-3 2-3-1.5-3 2z",
} as const;

export type IconName = keyof typeof DRAWINGS;

export function icon(name: IconName): SVGSVGElement {
  const space = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(space, "svg");
  svg.setAttribute("viewBox", "0 0 16 16");
  svg.setAttribute("width", "14");
  svg.setAttribute("height", "14");
  svg.setAttribute("aria-hidden", "true");
  const path = document.createElementNS(space, "path");
  path.setAttribute("d", DRAWINGS[name]);
  path.setAttribute("fill", "currentColor");
  path.setAttribute("fill-rule", "evenodd");
  svg.append(path);
  return svg;
}
