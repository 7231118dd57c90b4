package org.pendant.project.program;

import static org.pendant.project.program.ProgramTreeTexts.text;

import java.util.function.UnaryOperator;
import java.util.regex.Pattern;

/** Step names: what a node is called, in one line: in the tree and in the labels of the script. */
public final class StepNames {
  private static final Pattern BLANKS = Pattern.compile("\\s+");
  private static final String UNNAMED = "?";

  private StepNames() {}

  /** The line for a node; without its children. */
  public static String label(ProgramNode node) {
    return label(node.step());
  }

  /** The line for a step. */
  public static String label(Step step) {
    return label(step, signal -> signal);
  }

  /**
   * The line for a step as screens show it.
   *
   * @param signals what people call a signal
   */
  public static String label(Step step, UnaryOperator<String> signals) {
    return BLANKS.matcher(line(step, signals)).replaceAll(" ");
  }

  private static String line(Step step, UnaryOperator<String> signals) {
    return switch (step) {
      case Section each -> section(each);
      case MotionStep each -> motion(each, signals);
      case ActionStep each -> action(each, signals);
      case FlowStep each -> flow(each);
      case TemplateStep each -> template(each);
      case ForeignStep each -> foreign(each);
    };
  }

  private static String section(Section section) {
    return switch (section) {
      case Section.InitialValues _ -> text("initialValues");
      case Section.BeforeStart _ -> text("beforeStartSection");
      case Section.MainProgram _ -> text("robotProgram");
      case Section.ThreadSection thread -> name(thread.name());
      case Section.Event event -> text("eventOf", condition(event.condition()));
      case Section.SubProgram sub -> name(sub.name());
    };
  }

  private static String motion(MotionStep motion, UnaryOperator<String> signals) {
    return switch (motion) {
      case MotionStep.Move move -> move(move.kind());
      case MotionStep.Waypoint waypoint -> waypoint(waypoint.target());
      case MotionStep.CircleMove _ -> "CircleMove";
      case MotionStep.Direction direction -> text("directionOf", direction(direction));
      case MotionStep.Until until -> until(until.rule(), signals);
      case MotionStep.Home _ -> text("home");
    };
  }

  private static String move(MoveKind kind) {
    return switch (kind) {
      case JOINT -> "MoveJ";
      case LINEAR -> "MoveL";
      case PROCESS -> "MoveP";
    };
  }

  private static String waypoint(WaypointTarget target) {
    return switch (target) {
      case WaypointTarget.Fixed fixed -> name(fixed.name());
      case WaypointTarget.Relative relative -> name(relative.name());
      case WaypointTarget.Variable variable -> condition(variable.expression());
    };
  }

  private static String direction(MotionStep.Direction direction) {
    if (!direction.expression().isBlank()) {
      return name(direction.feature()) + " " + condition(direction.expression());
    }
    double[] parts = {direction.x(), direction.y(), direction.z()};
    String axes = "XYZ";
    int axis = -1;
    int used = 0;
    for (int i = 0; i < parts.length; i++) {
      if (parts[i] != 0) {
        axis = i;
        used++;
      }
    }
    String way =
        used == 1
            ? axes.charAt(axis) + (parts[axis] > 0 ? "+" : "-")
            : "[" + number(parts[0]) + ", " + number(parts[1]) + ", " + number(parts[2]) + "]";
    return name(direction.feature()) + " " + way;
  }

  private static String until(UntilRule rule, UnaryOperator<String> signals) {
    return switch (rule) {
      case UntilRule.Distance distance -> text("untilDistanceM", number(distance.distanceM()));
      case UntilRule.Contact _ -> text("untilToolContact");
      case UntilRule.Expression expression ->
          text("untilCondition", condition(expression.condition()));
      case UntilRule.DigitalInput input ->
          text("untilCondition", level(signals.apply(input.signal()), input.level()));
    };
  }

  private static String action(ActionStep action, UnaryOperator<String> signals) {
    return switch (action) {
      case ActionStep.Wait wait -> wait(wait.what(), signals);
      case ActionStep.SetAction set -> setting(set.setting(), signals);
      case ActionStep.Popup popup -> named("popup", "popupNamed", popup.text());
      case ActionStep.Halt _ -> text("halt");
      case ActionStep.Comment comment -> "'" + comment.text() + "'";
      case ActionStep.Folder folder -> folder.name().isBlank() ? text("folder") : folder.name();
      case ActionStep.Assignment set ->
          name(set.variable()) + " \u2254 " + condition(set.expression());
      case ActionStep.OperatorInput input -> operatorInput(name(input.variable()), input.kind());
      case ActionStep.Call call -> text("callOf", name(call.subProgram()));
      case ActionStep.ScriptLine line -> name(line.code());
      case ActionStep.ScriptFile file -> text("scriptOf", name(file.file()));
      case ActionStep.Timer timer -> timer(name(timer.name()), timer.action());
    };
  }

  private static String operatorInput(String variable, ActionStep.InputKind kind) {
    return switch (kind) {
      case BOOLEAN -> text("operatorBoolean", variable);
      case INTEGER -> text("operatorInteger", variable);
      case FLOAT -> text("operatorFloat", variable);
      case TEXT -> text("operatorText", variable);
    };
  }

  private static String timer(String name, ActionStep.TimerAction action) {
    return switch (action) {
      case START -> text("timerStart", name);
      case STOP -> text("timerStop", name);
      case RESET -> text("timerReset", name);
    };
  }

  private static String wait(WaitFor what, UnaryOperator<String> signals) {
    return switch (what) {
      case WaitFor.Nothing _ -> text("wait");
      case WaitFor.Time time -> text("waitTime", number(time.timeS()));
      case WaitFor.Digital digital ->
          text("waitFor", level(signals.apply(digital.signal()), digital.level()));
      case WaitFor.Analog analog ->
          text(
              "waitFor",
              name(signals.apply(analog.signal()))
                  + (analog.above() ? " > " : " < ")
                  + number(analog.value()));
      case WaitFor.Expression expression -> text("waitFor", condition(expression.condition()));
    };
  }

  private static String setting(Setting setting, UnaryOperator<String> signals) {
    return switch (setting) {
      case Setting.Nothing _ -> text("set");
      case Setting.Digital digital ->
          text(digital.level() ? "setOn" : "setOff", name(signals.apply(digital.signal())));
      case Setting.Analog analog ->
          text("setTo", name(signals.apply(analog.signal())), number(analog.value()));
      case Setting.Pulse pulse ->
          text("setPulse", name(signals.apply(pulse.signal())), number(pulse.timeS()));
      case Setting.Expression expression ->
          text(
              "setTo",
              name(signals.apply(expression.signal())),
              condition(expression.expression()));
      case Setting.NamedPayload payload -> text("setPayload", name(payload.name()));
      case Setting.Payload payload -> text("setPayloadMass", number(payload.massKg()));
      case Setting.Tcp tcp ->
          tcp.name().isEmpty() ? text("setTcp") : text("setTcpNamed", tcp.name());
      case Setting.Increment increment -> text("setIncremented", name(increment.variable()));
    };
  }

  private static String flow(FlowStep flow) {
    return switch (flow) {
      case FlowStep.If each -> text("ifCondition", condition(each.condition()));
      case FlowStep.ElseIf each -> text("elseIfCondition", condition(each.condition()));
      case FlowStep.Else _ -> text("else");
      case FlowStep.Loop loop -> loop(loop.rule());
      case FlowStep.Switch each -> text("switchOn", condition(each.expression()));
      case FlowStep.Case each -> text("caseOf", name(each.value()));
      case FlowStep.DefaultCase _ -> text("defaultCase");
    };
  }

  private static String loop(LoopRule rule) {
    return switch (rule) {
      case LoopRule.Forever _ -> text("loop");
      case LoopRule.Times times -> text("loopTimes", name(times.count()));
      case LoopRule.While each -> text("loopWhile", condition(each.condition()));
    };
  }

  private static String template(TemplateStep template) {
    return switch (template) {
      case TemplateStep.Palletizing each -> named("palletizing", "palletizingNamed", each.name());
      case TemplateStep.PatternPoint point -> role(point.role());
      case TemplateStep.Part part -> part(part.kind());
      case TemplateStep.Seek seek ->
          seek.destack()
              ? named("destack", "destackNamed", seek.name())
              : named("stack", "stackNamed", seek.name());
      case TemplateStep.Force force -> force(force.kind());
      case TemplateStep.Screwdriving each ->
          each.loosen() ? text("screwdrivingLoosen") : text("screwdriving");
      case TemplateStep.ConveyorTracking each -> text("conveyorTrackingOf", each.conveyor());
    };
  }

  private static String role(TemplateStep.PatternRole role) {
    return switch (role) {
      case APPROACH -> text("approach");
      case POINT -> text("patternReference");
      case EXIT -> text("exit");
    };
  }

  private static String force(TemplateStep.ForceKind kind) {
    return switch (kind) {
      case SIMPLE -> text("forceSimple");
      case FRAME -> text("forceFrame");
      case POINT -> text("forcePoint");
      case MOTION -> text("forceMotion");
    };
  }

  private static String part(TemplateStep.PartKind kind) {
    return switch (kind) {
      case BEFORE_START -> text("beforeStart");
      case AFTER_END -> text("afterEnd");
      case SEQUENCE -> text("sequence");
    };
  }

  private static String foreign(ForeignStep foreign) {
    return switch (foreign) {
      case ForeignStep.Contributed each when ExternalControl.is(each) -> each.type();
      case ForeignStep.Contributed each when each.source().isBlank() -> name(each.type());
      case ForeignStep.Contributed each -> name(each.type()) + ": " + each.source();
      case ForeignStep.Unknown each -> text("unknownNode", name(each.element()));
    };
  }

  private static String named(String key, String keyNamed, String name) {
    return name.isBlank() ? text(key) : text(keyNamed, name);
  }

  private static String name(String text) {
    return text.isBlank() ? UNNAMED : text.strip();
  }

  /** An expression as screens show it. */
  private static String condition(String expression) {
    return name(expression).replace("==", "\u225f");
  }

  private static String level(String signal, boolean level) {
    return name(signal) + " \u225f " + (level ? "True" : "False");
  }

  /** Without a fraction that says nothing. */
  private static String number(double value) {
    return value == Math.rint(value) && Math.abs(value) < 1e15
        ? Long.toString((long) value)
        : Double.toString(value);
  }
}
