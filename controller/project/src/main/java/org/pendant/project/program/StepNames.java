package org.pendant.project.program;

import java.util.Locale;
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
    return BLANKS.matcher(text(step, signals)).replaceAll(" ");
  }

  private static String text(Step step, UnaryOperator<String> signals) {
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
      case Section.InitialValues _ -> "Initial values";
      case Section.BeforeStart _ -> "BeforeStart";
      case Section.MainProgram _ -> "Robot Program";
      case Section.ThreadSection thread -> name(thread.name());
      case Section.Event event -> "Event " + condition(event.condition());
      case Section.SubProgram sub -> name(sub.name());
    };
  }

  private static String motion(MotionStep motion, UnaryOperator<String> signals) {
    return switch (motion) {
      case MotionStep.Move move -> move(move.kind());
      case MotionStep.Waypoint waypoint -> waypoint(waypoint.target());
      case MotionStep.CircleMove _ -> "CircleMove";
      case MotionStep.Direction direction -> "Direction: " + direction(direction);
      case MotionStep.Until until -> "Until " + until(until.rule(), signals);
      case MotionStep.Home _ -> "Home";
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
      case UntilRule.Distance distance -> "distance: " + number(distance.distanceM()) + " m";
      case UntilRule.Contact _ -> "tool contact";
      case UntilRule.Expression expression -> condition(expression.condition());
      case UntilRule.DigitalInput input -> level(signals.apply(input.signal()), input.level());
    };
  }

  private static String action(ActionStep action, UnaryOperator<String> signals) {
    return switch (action) {
      case ActionStep.Wait wait -> wait(wait.what(), signals);
      case ActionStep.SetAction set -> setting(set.setting(), signals);
      case ActionStep.Popup popup -> named("Popup", popup.text());
      case ActionStep.Halt _ -> "Halt";
      case ActionStep.Comment comment -> "'" + comment.text() + "'";
      case ActionStep.Folder folder -> folder.name().isBlank() ? "Folder" : folder.name();
      case ActionStep.Assignment set ->
          name(set.variable()) + " \u2254 " + condition(set.expression());
      case ActionStep.OperatorInput input ->
          name(input.variable()) + " \u2254 operator: " + word(input.kind());
      case ActionStep.Call call -> "Call " + name(call.subProgram());
      case ActionStep.ScriptLine line -> name(line.code());
      case ActionStep.ScriptFile file -> "Script: " + name(file.file());
      case ActionStep.Timer timer -> name(timer.name()) + ": " + word(timer.action());
    };
  }

  private static String wait(WaitFor what, UnaryOperator<String> signals) {
    return switch (what) {
      case WaitFor.Nothing _ -> "Wait";
      case WaitFor.Time time -> "Wait: " + number(time.timeS());
      case WaitFor.Digital digital ->
          "Wait " + level(signals.apply(digital.signal()), digital.level());
      case WaitFor.Analog analog ->
          "Wait "
              + name(signals.apply(analog.signal()))
              + (analog.above() ? " > " : " < ")
              + number(analog.value());
      case WaitFor.Expression expression -> "Wait " + condition(expression.condition());
    };
  }

  private static String setting(Setting setting, UnaryOperator<String> signals) {
    return switch (setting) {
      case Setting.Nothing _ -> "Set";
      case Setting.Digital digital ->
          "Set " + name(signals.apply(digital.signal())) + " = " + (digital.level() ? "On" : "Off");
      case Setting.Analog analog ->
          "Set " + name(signals.apply(analog.signal())) + " = " + number(analog.value());
      case Setting.Pulse pulse ->
          "Set " + name(signals.apply(pulse.signal())) + ": pulse " + number(pulse.timeS());
      case Setting.Expression expression ->
          "Set "
              + name(signals.apply(expression.signal()))
              + " = "
              + condition(expression.expression());
      case Setting.NamedPayload payload -> "Set payload: " + name(payload.name());
      case Setting.Payload payload -> "Set payload: " + number(payload.massKg()) + " kg";
      case Setting.Tcp tcp -> tcp.name().isEmpty() ? "Set TCP" : "Set TCP: " + tcp.name();
      case Setting.Increment increment ->
          "Set " + name(increment.variable()) + " \u2254 " + name(increment.variable()) + " + 1";
    };
  }

  private static String flow(FlowStep flow) {
    return switch (flow) {
      case FlowStep.If each -> "If " + condition(each.condition());
      case FlowStep.ElseIf each -> "ElseIf " + condition(each.condition());
      case FlowStep.Else _ -> "Else";
      case FlowStep.Loop loop -> loop(loop.rule());
      case FlowStep.Switch each -> "Switch " + condition(each.expression());
      case FlowStep.Case each -> "Case " + name(each.value());
      case FlowStep.DefaultCase _ -> "Default case";
    };
  }

  private static String loop(LoopRule rule) {
    return switch (rule) {
      case LoopRule.Forever _ -> "Loop";
      case LoopRule.Times times -> "Loop " + name(times.count()) + " times";
      case LoopRule.While each -> "Loop " + condition(each.condition());
    };
  }

  private static String template(TemplateStep template) {
    return switch (template) {
      case TemplateStep.Palletizing each -> named("Palletizing", each.name());
      case TemplateStep.PatternPoint point -> capital(word(point.role()));
      case TemplateStep.Part part -> part(part.kind());
      case TemplateStep.Seek seek -> named(seek.destack() ? "Destack" : "Stack", seek.name());
      case TemplateStep.Force force -> "Force: " + word(force.kind());
      case TemplateStep.Screwdriving each ->
          each.loosen() ? "Screwdriving: loosen" : "Screwdriving";
      case TemplateStep.ConveyorTracking each -> "Conveyor tracking " + each.conveyor();
    };
  }

  private static String part(TemplateStep.PartKind kind) {
    return switch (kind) {
      case BEFORE_START -> "Before start";
      case AFTER_END -> "After end";
      case SEQUENCE -> "Sequence";
    };
  }

  private static String foreign(ForeignStep foreign) {
    return switch (foreign) {
      case ForeignStep.Contributed each when ExternalControl.is(each) -> each.type();
      case ForeignStep.Contributed each -> named(name(each.type()), each.source());
      case ForeignStep.Unknown each -> "Unknown: " + name(each.element());
    };
  }

  private static String named(String kind, String name) {
    return name.isBlank() ? kind : kind + ": " + name;
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

  private static String word(Enum<?> constant) {
    return constant.name().toLowerCase(Locale.ROOT);
  }

  private static String capital(String word) {
    return Character.toUpperCase(word.charAt(0)) + word.substring(1);
  }

  /** Without a fraction that says nothing. */
  private static String number(double value) {
    return value == Math.rint(value) && Math.abs(value) < 1e15
        ? Long.toString((long) value)
        : Double.toString(value);
  }
}
