import { ArrayTool } from './array-tool.ts';
import { BoxTool, GridTool, HexagonTool, KeepOutTool, RectangleTool } from './figure-tools.ts';
import { JointTool } from './joint-tool.ts';
import { LineTool } from './line-tool.ts';
import { MeasureTool } from './measure-tool.ts';
import { SplitTool } from './node-tools.ts';
import { SelectTool } from './select-tool.ts';
import { ShaftTool } from './shaft-tool.ts';
import type { Tool, ToolContext, ToolId } from './tool.ts';

/** One of each tool. */
export function createTools(context: ToolContext): ReadonlyMap<ToolId, Tool> {
  const tools: readonly Tool[] = [
    new SelectTool(context),
    new LineTool(context),
    new RectangleTool(context),
    new BoxTool(context),
    new GridTool(context),
    new HexagonTool(context),
    new SplitTool(context),
    new JointTool(context),
    new KeepOutTool(context),
    new ShaftTool(context),
    new ArrayTool(context),
    new MeasureTool(context),
  ];
  return new Map(tools.map((tool) => [tool.id, tool]));
}
