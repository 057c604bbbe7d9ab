// What softrod uses of @fluent/bundle.
export type Pattern = string | object[];
export class FluentResource {
  constructor(source: string);
}
export class FluentBundle {
  constructor(locales: string | string[], options?: { useIsolating?: boolean });
  addResource(resource: FluentResource): Error[];
  getMessage(name: string): { value: Pattern | null; attributes: Record<string, Pattern> } | undefined;
  formatPattern(pattern: Pattern, values?: Record<string, string | number> | null, errors?: Error[]): string;
}
