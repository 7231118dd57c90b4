package org.pendant.project.program.script;

import org.pendant.project.program.ExternalControl;
import org.pendant.project.program.ForeignStep;
import org.pendant.project.program.ProgramNode;

/** Foreign node writer: writes what stands in for nodes of others, or a remark. */
final class ForeignWriter {
  private final ScriptContext context;
  private final ScriptLines lines;

  ForeignWriter(ScriptContext context) {
    this.context = context;
    lines = context.lines();
  }

  /** A node; it has none below it. */
  void write(ProgramNode node, ForeignStep step) {
    lines.begin(node);
    switch (step) {
      case ForeignStep.Contributed each -> {
        String who = ScriptText.oneLine(each.source() + ": " + each.type());
        lines.line("# begin: URCap node " + who);
        if (ExternalControl.is(each)) {
          control();
        }
        each.stub().forEach(lines::code);
        lines.line("# end: URCap node " + who);
      }
      case ForeignStep.Unknown each ->
          lines.line("# does nothing: unknown node " + ScriptText.oneLine(each.element()));
    }
    lines.end();
  }

  private void control() {
    context
        .control()
        .ifPresentOrElse(
            script -> lines.received(script.loop()),
            () ->
                lines.line(
                    "# the script that "
                        + ScriptText.oneLine(context.installation().controlHost().text())
                        + " is asked for when the program starts"));
  }
}
