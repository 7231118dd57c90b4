package org.pendant.project.program.check;

import static org.pendant.project.program.check.ProgramCheckTexts.text;

import org.pendant.controller.installation.InstallationVariable;
import org.pendant.controller.installation.Wiring;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.NodeFields;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.Setting;
import org.pendant.project.program.WaitFor;

/** Action check: checks nodes that do something else than moving. */
final class ActionCheck {
  private final CheckContext findings;
  private final SignalCheck signals;

  ActionCheck(CheckContext findings, SignalCheck signals) {
    this.findings = findings;
    this.signals = signals;
  }

  void check(ProgramNode node, ActionStep step) {
    switch (step) {
      case ActionStep.Wait wait -> wait(node, wait.what());
      case ActionStep.SetAction set -> set(node, set.setting());
      case ActionStep.Popup popup -> popup(node, popup);
      case ActionStep.Halt _, ActionStep.Comment _, ActionStep.Folder _ -> {}
      case ActionStep.Assignment assignment -> {
        findings.identifier(node, "variable", text("variable"), assignment.variable());
        findings.expression(node, "expression", text("value"), assignment.expression());
      }
      case ActionStep.OperatorInput input ->
          findings.identifier(node, "variable", text("variable"), input.variable());
      case ActionStep.Call call -> call(node, call.subProgram());
      case ActionStep.ScriptLine line -> {
        if (line.code().isBlank()) {
          findings.problem(node, "code", text("scriptLineEmpty"));
        }
      }
      case ActionStep.ScriptFile file -> {
        if (file.lines().isEmpty()) {
          findings.problem(
              node,
              file.file().isBlank() ? "file" : "lines",
              file.file().isBlank() ? text("noScriptFile") : text("scriptFileEmpty", file.file()));
        }
      }
      case ActionStep.Timer timer -> findings.identifier(node, "name", text("timer"), timer.name());
    }
  }

  private void wait(ProgramNode node, WaitFor what) {
    switch (what) {
      case WaitFor.Nothing _ -> {}
      case WaitFor.Time time -> findings.number(node, NodeFields.WAIT_TIME, time.timeS());
      case WaitFor.Digital digital -> signals.digital(node, "what", digital.signal());
      case WaitFor.Analog analog -> {
        signals.analog(node, "what", analog.signal());
        findings.number(node, NodeFields.waitLevel(analog.signal(), wiring()), analog.value());
      }
      case WaitFor.Expression expression ->
          findings.expression(node, "what", text("condition"), expression.condition());
    }
  }

  private void set(ProgramNode node, Setting setting) {
    switch (setting) {
      case Setting.Nothing _ -> {}
      case Setting.Digital digital -> signals.digitalOut(node, "setting", digital.signal());
      case Setting.Analog analog -> {
        signals.analogOut(node, "setting", analog.signal());
        findings.number(node, NodeFields.analogOutput(analog.signal(), wiring()), analog.value());
      }
      case Setting.Pulse pulse -> {
        signals.digitalOut(node, "setting", pulse.signal());
        findings.number(node, NodeFields.PULSE_TIME, pulse.timeS());
      }
      case Setting.Expression expression -> {
        signals.output(node, "setting", expression.signal());
        findings.expression(node, "setting", text("value"), expression.expression());
      }
      case Setting.NamedPayload payload -> {
        if (findings.installation().payload(payload.name()).isEmpty()) {
          findings.problem(
              node,
              "setting",
              payload.name().isBlank()
                  ? text("payloadMissing")
                  : text("noSuchPayload", payload.name()));
        }
      }
      case Setting.Payload payload -> {
        findings.number(node, NodeFields.PAYLOAD_MASS, payload.massKg());
        findings.number(node, NodeFields.PAYLOAD_X, payload.cogXM());
        findings.number(node, NodeFields.PAYLOAD_Y, payload.cogYM());
        findings.number(node, NodeFields.PAYLOAD_Z, payload.cogZM());
      }
      case Setting.Tcp tcp -> {
        if (tcp.name().isEmpty()) {
          for (int i = 0; i < Pose.SIZE; i++) {
            findings.number(node, NodeFields.tcp(i), tcp.inFlange().get(i));
          }
        } else {
          findings.namedTool(node, "setting", tcp.name());
        }
      }
      case Setting.Increment increment -> increment(node, increment.variable());
    }
  }

  private Wiring wiring() {
    return findings.installation().wiring();
  }

  private void increment(ProgramNode node, String variable) {
    if (variable.isBlank()) {
      findings.problem(node, "setting", text("variableMissing"));
    } else if (findings.installation().variables().stream()
        .map(InstallationVariable::name)
        .noneMatch(variable::equals)) {
      findings.problem(node, "setting", text("noSuchVariable", variable));
    }
  }

  private void popup(ProgramNode node, ActionStep.Popup popup) {
    if (popup.isExpression()) {
      findings.expression(node, "text", text("popupText"), popup.text());
    } else if (popup.text().isBlank()) {
      findings.problem(node, "text", text("popupTextMissing"));
    }
  }

  private void call(ProgramNode node, String subProgram) {
    if (subProgram.isBlank()) {
      findings.problem(node, "subProgram", text("subProgramMissing"));
    } else if (!findings.subPrograms().contains(subProgram)) {
      findings.problem(node, "subProgram", text("noSuchSubProgram", subProgram));
    }
  }
}
