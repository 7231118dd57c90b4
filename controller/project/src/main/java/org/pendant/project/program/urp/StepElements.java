package org.pendant.project.program.urp;

import java.util.List;
import java.util.OptionalDouble;
import java.util.regex.Pattern;
import org.pendant.models.pose.Pose;
import org.pendant.project.polyscope.xml.XmlText;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.LoopRule;
import org.pendant.project.program.Setting;
import org.pendant.project.program.WaitFor;

/**
 * Step elements: begins the elements of steps that do not move the arm, with all that is in them
 * but other nodes.
 */
final class StepElements {
  private static final Pattern NAME = Pattern.compile("[A-Za-z_]\\w*");

  private final XmlText out;

  StepElements(XmlText out) {
    this.out = out;
  }

  /**
   * Begins the element of a step.
   *
   * @return whether there is one; if not, nothing was written
   */
  boolean open(ActionStep step) {
    switch (step) {
      case ActionStep.Wait wait -> waitFor(wait.what());
      case ActionStep.SetAction set -> {
        return set(set.setting());
      }
      case ActionStep.Popup popup -> {
        return popup(popup);
      }
      case ActionStep.Halt _ -> out.open("Halt");
      case ActionStep.Comment comment -> out.open("Comment", "comment", comment.text());
      case ActionStep.Folder folder -> out.open("Folder", "name", folder.name());
      case ActionStep.Assignment assignment -> {
        out.open("Assignment", "valueSource", "Expression");
        variable("variable", assignment.variable());
        expression("expression", assignment.expression());
      }
      // its attributes are not known
      case ActionStep.OperatorInput _ -> {
        return false;
      }
      // written where the sub programs are known
      case ActionStep.Call _ -> {
        return false;
      }
      case ActionStep.ScriptLine line -> {
        out.open("Script", "type", "Line");
        expression("expression", line.code());
      }
      case ActionStep.ScriptFile file -> script(file);
      case ActionStep.Timer timer -> {
        String action =
            switch (timer.action()) {
              case START -> "Start";
              case STOP -> "Stop";
              case RESET -> "Reset";
            };
        out.open("Timer", "action", action);
        variable("variable", timer.name());
      }
    }
    return true;
  }

  /** Begins the element of a step; all of them have one. */
  void open(FlowStep step) {
    switch (step) {
      case FlowStep.If branch -> branch("If", branch.condition(), branch.continuously());
      case FlowStep.ElseIf branch -> branch("ElseIf", branch.condition(), branch.continuously());
      case FlowStep.Else _ -> branch("Else", "", false);
      case FlowStep.Loop loop -> loop(loop.rule());
      case FlowStep.Switch choice -> {
        out.open("Switch");
        expression("expression", choice.expression());
      }
      case FlowStep.Case choice -> out.open("Case", "caseValue", choice.value());
      case FlowStep.DefaultCase _ -> out.open("DefaultCase");
    }
  }

  /** An element with an expression in it, one sign after the other. */
  void expression(String name, String text) {
    out.open(name);
    text.codePoints()
        .forEach(each -> out.leaf("ExpressionChar", "character", Character.toString(each)));
    out.close();
  }

  /** A variable: in full where it is first, else a reference. */
  void variable(String element, String name) {
    if (out.first(element, "variable " + name)) {
      out.open(element, "name", name, "prefersPersistentValue", "false", "favourite", "false");
      out.leaf("initializeExpression").close();
    }
  }

  void pin(String signal) {
    out.leaf("pin", "referencedName", UrpSignals.there(signal));
  }

  static boolean isName(String text) {
    return NAME.matcher(text).matches();
  }

  private static String digit(boolean level) {
    return level ? "1" : "0";
  }

  private void waitFor(WaitFor what) {
    switch (what) {
      case WaitFor.Nothing _ -> out.open("Wait", "type", "NoWait");
      case WaitFor.Time time -> {
        out.open("Wait", "type", "Sleep");
        out.text("waitTime", Double.toString(time.timeS()));
      }
      case WaitFor.Digital digital -> {
        out.open("Wait", "type", "DigitalInput");
        pin(digital.signal());
        out.text("digitalValue", digit(digital.level()));
      }
      case WaitFor.Analog analog -> {
        out.open("Wait", "type", "AnalogInput");
        pin(analog.signal());
        out.text("analogComparison", digit(analog.above()));
        out.text("analogValue", Double.toString(analog.value()));
      }
      case WaitFor.Expression expression -> {
        out.open("Wait", "type", "Condition");
        expression("expression", expression.condition());
      }
    }
  }

  private boolean set(Setting setting) {
    switch (setting) {
      case Setting.Nothing _ -> out.open("Set", "type", "NoAction");
      case Setting.Digital digital -> {
        out.open("Set", "type", "DigitalOutput");
        pin(digital.signal());
        out.text("digitalValue", digit(digital.level()));
      }
      case Setting.Analog analog -> {
        out.open("Set", "type", "AnalogOutput");
        pin(analog.signal());
        out.text("analogValue", Double.toString(analog.value()));
      }
      case Setting.Expression expression -> {
        out.open("Set", "type", "ExpressionOutput");
        pin(expression.signal());
        expression("expression", expression.expression());
      }
      case Setting.NamedPayload payload -> out.open("SetPayload", "workpieceName", payload.name());
      case Setting.Tcp tcp -> {
        if (!tcp.inFlange().equals(Pose.ZERO)) {
          return false;
        }
        out.open("Set", "type", "NoAction");
        out.leaf("tcp", "referencedName", tcp.name());
      }
      case Setting.Pulse _, Setting.Payload _, Setting.Increment _ -> {
        return false;
      }
    }
    return true;
  }

  private boolean popup(ActionStep.Popup popup) {
    String type =
        switch (popup.kind()) {
          case MESSAGE -> "Message";
          case WARNING -> "Warning";
          case ERROR -> "Error";
        };
    String halts = Boolean.toString(popup.halts());
    if (!popup.isExpression()) {
      out.open(
          "Popup",
          "type",
          type,
          "haltProgram",
          halts,
          "message",
          popup.text(),
          "inputType",
          "Text");
      return true;
    }
    if (!isName(popup.text())) {
      return false;
    }
    out.open("Popup", "type", type, "haltProgram", halts, "message", "", "inputType", "Variable");
    variable("variable", popup.text());
    return true;
  }

  private void script(ActionStep.ScriptFile file) {
    List<String> lines = file.lines();
    out.open("Script", "type", "File");
    out.text("cachedContents", lines.isEmpty() ? "" : String.join("\n", lines) + "\n");
    out.text("file", file.file(), "resolves-to", "file");
  }

  private void branch(String type, String condition, boolean continuously) {
    out.open("If", "type", type, "checkContinuously", Boolean.toString(continuously));
    expression("expression", condition);
  }

  private void loop(LoopRule rule) {
    switch (rule) {
      case LoopRule.Forever _ -> out.open("Loop", "type", "Forever");
      case LoopRule.Times times -> {
        out.open("Loop", "type", "Counting", "count", times.count());
        if (!times.variable().isEmpty()) {
          variable("variable", times.variable());
        }
      }
      case LoopRule.While loop -> {
        out.open("Loop", "type", "While");
        out.attribute("checkContinuously", Boolean.toString(loop.continuously()));
        expression("expression", loop.condition());
      }
    }
  }

  /** An attribute for a number that may be missing. */
  void optional(String name, OptionalDouble value) {
    if (value.isPresent()) {
      out.attribute(name, Double.toString(value.getAsDouble()));
    }
  }
}
