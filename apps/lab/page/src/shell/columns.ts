// The three columns of the page.
export const COLUMNS = ["program", "view", "elements"] as const;
export type ColumnName = (typeof COLUMNS)[number];
export const TITLES: Record<ColumnName, string> = { program: "Program", view: "3D view", elements: "Laboratory" };
