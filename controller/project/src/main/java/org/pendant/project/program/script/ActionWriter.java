package org.pendant.project.program.script;

import java.util.Optional;
import org.pendant.controller.installation.NamedPayload;
import org.pendant.controller.installation.NamedTool;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.Setting;
import org.pendant.project.program.WaitFor;

/** Action writer: writes what is neither a move nor a decision. */
final class ActionWriter {
  private final ScriptContext context;
  private final ScriptStepWriter steps;
  private final ScriptLines lines;
  private final ActiveTool tool;
  private final SignalCode signals;

  ActionWriter(ScriptContext context, ScriptStepWriter steps, ActiveTool tool) {
    this.context = context;
    this.steps = steps;
    this.tool = tool;
    lines = context.lines();
    signals = new SignalCode(context.installation());
  }

  /** A node with all below it. */
  void write(ProgramNode node, ActionStep step) {
    if (step instanceof ActionStep.Comment || step instanceof ActionStep.Folder) {
      lines.begin(node, ScriptLines.NO_BREAK);
    } else {
      lines.begin(node);
    }
    switch (step) {
      case ActionStep.Wait wait -> waitFor(wait.what());
      case ActionStep.SetAction set -> set(set.setting());
      case ActionStep.Popup popup -> popup(popup);
      case ActionStep.Halt _ -> lines.line("halt");
      case ActionStep.Comment comment ->
          comment.text().lines().forEach(line -> lines.line("# " + ScriptText.oneLine(line)));
      case ActionStep.Folder _ -> steps.writeAll(node.children());
      case ActionStep.Assignment each -> assign(each.variable(), each.expression());
      case ActionStep.OperatorInput input ->
          assign(
              input.variable(), ask(input.kind()) + "(" + ScriptText.string(input.message()) + ")");
      case ActionStep.Call call -> call(call.subProgram());
      case ActionStep.ScriptLine line -> {
        line.code().lines().forEach(lines::code);
      }
      case ActionStep.ScriptFile file -> {
        file.lines().forEach(lines::code);
      }
      case ActionStep.Timer timer -> timer(timer);
    }
    lines.end();
  }

  private void waitFor(WaitFor what) {
    switch (what) {
      case WaitFor.Nothing _ -> {}
      case WaitFor.Time time -> lines.line("sleep(" + ScriptText.number(time.timeS()) + ")");
      case WaitFor.Digital digital ->
          whileNot(
              signals
                  .read(digital.signal())
                  .map(level -> level + " == " + ScriptText.bool(!digital.level())),
              digital.signal());
      case WaitFor.Analog analog ->
          whileNot(
              signals
                  .read(analog.signal())
                  .map(
                      value ->
                          value
                              + (analog.above() ? " <= " : " >= ")
                              + ScriptText.number(analog.value())),
              analog.signal());
      case WaitFor.Expression expression -> {
        String condition = ScriptText.condition(expression.condition());
        whileNot(Optional.of("not" + condition), "");
      }
    }
  }

  private void whileNot(Optional<String> still, String signal) {
    if (still.isEmpty()) {
      noSignal(signal);
      return;
    }
    lines.open("while (" + still.get() + "):");
    lines.line("sync()");
    lines.close();
  }

  private void noSignal(String signal) {
    lines.line("# there is no such signal: " + ScriptText.oneLine(signal));
  }

  private void set(Setting setting) {
    switch (setting) {
      case Setting.Nothing _ -> {}
      case Setting.Digital digital -> output(digital.signal(), ScriptText.bool(digital.level()));
      case Setting.Analog analog -> output(analog.signal(), ScriptText.number(analog.value()));
      case Setting.Pulse pulse -> {
        output(pulse.signal(), "True");
        lines.line("sleep(" + ScriptText.number(pulse.timeS()) + ")");
        output(pulse.signal(), "False");
      }
      case Setting.Expression each ->
          output(each.signal(), ScriptText.oneLine(each.expression().strip()));
      case Setting.NamedPayload payload ->
          context
              .installation()
              .payload(payload.name())
              .map(ActionWriter::payload)
              .ifPresent(lines::line);
      case Setting.Payload payload ->
          lines.line(
              "set_target_payload("
                  + ScriptText.number(payload.massKg())
                  + ", "
                  + ScriptText.list(payload.cogXM(), payload.cogYM(), payload.cogZM())
                  + ")");
      case Setting.Tcp tcp ->
          tool.change(
              tcp.name().isEmpty()
                  ? tcp.inFlange()
                  : context
                      .installation()
                      .tool(tcp.name())
                      .map(NamedTool::inFlange)
                      .orElse(tcp.inFlange()));
      case Setting.Increment increment ->
          assign(increment.variable(), context.names().variable(increment.variable()) + " + 1");
    }
  }

  /** What declares a payload of the installation. */
  static String payload(NamedPayload payload) {
    return "set_target_payload("
        + ScriptText.number(payload.massKg())
        + ", "
        + ScriptText.list(payload.cogM().x(), payload.cogM().y(), payload.cogM().z())
        + ", "
        + ScriptText.list(
            payload.inertia().ixx(),
            payload.inertia().iyy(),
            payload.inertia().izz(),
            payload.inertia().ixy(),
            payload.inertia().ixz(),
            payload.inertia().iyz())
        + ")";
  }

  private void output(String signal, String value) {
    if (value.isEmpty()) {
      incomplete();
      return;
    }
    signals.write(signal, value).ifPresentOrElse(lines::line, () -> noSignal(signal));
  }

  private void incomplete() {
    lines.line("# this node is not complete");
  }

  private void popup(ActionStep.Popup popup) {
    if (popup.isExpression() && popup.text().isBlank()) {
      incomplete();
      return;
    }
    String text =
        popup.isExpression()
            ? "str_cat(\"\", " + ScriptText.oneLine(popup.text().strip()) + ")"
            : ScriptText.string(popup.text());
    String kind =
        switch (popup.kind()) {
          case MESSAGE -> "\"Message\", False, False";
          case WARNING -> "\"Warning\", True, False";
          case ERROR -> "\"Error\", False, True";
        };
    String blocking = ScriptText.bool(!popup.halts());
    lines.line("popup(" + text + ", " + kind + ", blocking=" + blocking + ")");
    if (popup.halts()) {
      lines.line("halt");
    }
  }

  private void assign(String variable, String expression) {
    if (variable.isBlank() || expression.isBlank()) {
      incomplete();
      return;
    }
    lines.line(
        "global "
            + context.names().variable(variable)
            + " = "
            + ScriptText.oneLine(expression.strip()));
  }

  private static String ask(ActionStep.InputKind kind) {
    return switch (kind) {
      case BOOLEAN -> "request_boolean_from_primary_client";
      case INTEGER -> "request_integer_from_primary_client";
      case FLOAT -> "request_float_from_primary_client";
      case TEXT -> "request_string_from_primary_client";
    };
  }

  private void call(String subProgram) {
    if (context.survey().subPrograms().containsKey(subProgram)) {
      lines.line(context.names().function(subProgram) + "()");
    } else {
      lines.line("# there is no such subprogram: " + ScriptText.oneLine(subProgram));
    }
  }

  private void timer(ActionStep.Timer timer) {
    if (timer.name().isBlank()) {
      incomplete();
      return;
    }
    switch (timer.action()) {
      case START -> lines.line(context.counting(timer.name()) + " = True");
      case STOP -> lines.line(context.counting(timer.name()) + " = False");
      case RESET -> lines.line(context.names().variable(timer.name()) + " = 0.0");
    }
  }
}
