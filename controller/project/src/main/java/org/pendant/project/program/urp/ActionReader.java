package org.pendant.project.program.urp;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.pendant.models.pose.Pose;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.polyscope.xml.XmlElement;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.ActionStep.InputKind;
import org.pendant.project.program.ActionStep.PopupKind;
import org.pendant.project.program.ActionStep.TimerAction;
import org.pendant.project.program.Setting;
import org.pendant.project.program.Step;
import org.pendant.project.program.WaitFor;

/** Action reader: understands the elements that wait, set, ask and compute. */
final class ActionReader {
  private final ExpressionReader expressions;
  private final UrpSignals signals;

  ActionReader(ExpressionReader expressions, UrpSignals signals) {
    this.expressions = expressions;
    this.signals = signals;
  }

  /** The step of an element; empty if it is none of these. */
  Optional<Step> step(XmlElement element) throws UnreadableFile {
    return switch (SwitchedOff.kind(element)) {
      case "Wait" -> waitFor(element).map(ActionStep.Wait::new);
      case "Set" -> setting(element).map(ActionStep.SetAction::new);
      case "SetPayload" -> payload(element).map(ActionStep.SetAction::new);
      case "Popup" -> popup(element);
      case "Halt" -> Optional.of(new ActionStep.Halt());
      case "Comment" -> Optional.of(new ActionStep.Comment(element.text("comment")));
      case "Folder" -> Optional.of(new ActionStep.Folder(element.text("name")));
      case "Assignment" -> assignment(element);
      case "CallSubProgram" -> call(element);
      case "Script" -> script(element);
      case "Timer" -> timer(element);
      default -> Optional.empty();
    };
  }

  private Optional<WaitFor> waitFor(XmlElement element) throws UnreadableFile {
    return switch (element.text("type")) {
      case "NoWait" -> Optional.of(new WaitFor.Nothing());
      case "Sleep" -> {
        OptionalDouble time = Values.either(element, "waitTime");
        yield time.isEmpty() ? Optional.empty() : Optional.of(new WaitFor.Time(time.getAsDouble()));
      }
      case "DigitalInput" ->
          Optional.of(
              new WaitFor.Digital(signals.in(element), Values.yes(element, "digitalValue")));
      case "AnalogInput" -> analog(element);
      case "Condition" -> Optional.of(new WaitFor.Expression(expressions.in(element)));
      default -> Optional.empty();
    };
  }

  private Optional<WaitFor> analog(XmlElement element) throws UnreadableFile {
    OptionalDouble value = Values.either(element, "analogValue");
    OptionalDouble comparison = Values.either(element, "analogComparison");
    // 0 is below, 1 above; there is no node for anything else
    boolean known =
        comparison.equals(OptionalDouble.of(0)) || comparison.equals(OptionalDouble.of(1));
    return value.isEmpty() || !known
        ? Optional.empty()
        : Optional.of(
            new WaitFor.Analog(
                signals.in(element), comparison.getAsDouble() == 1, value.getAsDouble()));
  }

  private Optional<Setting> setting(XmlElement element) throws UnreadableFile {
    return switch (element.text("type")) {
      case "NoAction" -> {
        Optional<XmlElement> tcp = element.child("tcp");
        yield Optional.of(
            tcp.isEmpty()
                ? new Setting.Nothing()
                : new Setting.Tcp(expressions.name(tcp.get()), Pose.ZERO));
      }
      case "DigitalOutput" ->
          Optional.of(
              new Setting.Digital(signals.in(element), Values.yes(element, "digitalValue")));
      case "AnalogOutput" -> {
        OptionalDouble value = Values.either(element, "analogValue");
        yield value.isEmpty()
            ? Optional.empty()
            : Optional.of(new Setting.Analog(signals.in(element), value.getAsDouble()));
      }
      case "ExpressionOutput" ->
          Optional.of(new Setting.Expression(signals.in(element), expressions.in(element)));
      default -> Optional.empty();
    };
  }

  private static Optional<Setting> payload(XmlElement element) {
    Optional<String> name = element.attribute("workpieceName");
    double[] cog = Values.numbers(element.text("centerOfGravity"));
    OptionalDouble mass = Values.attribute(element, "mass");
    if (name.isPresent()) {
      return Optional.of(new Setting.NamedPayload(name.get()));
    }
    return mass.isPresent() && cog.length == 3
        ? Optional.of(new Setting.Payload(mass.getAsDouble(), cog[0], cog[1], cog[2]))
        : Optional.empty();
  }

  private Optional<Step> popup(XmlElement element) throws UnreadableFile {
    PopupKind kind =
        switch (element.text("type").toLowerCase(Locale.ROOT)) {
          case "warning" -> PopupKind.WARNING;
          case "error" -> PopupKind.ERROR;
          default -> PopupKind.MESSAGE;
        };
    boolean halts = Values.yes(element, "haltProgram");
    String variable = expressions.variable(element);
    boolean isExpression = element.attribute("inputType").orElse("Text").equals("Variable");
    return Optional.of(
        new ActionStep.Popup(
            isExpression ? variable : element.text("message"), isExpression, kind, halts));
  }

  private Optional<Step> assignment(XmlElement element) throws UnreadableFile {
    String variable = expressions.variable(element);
    if (element.attribute("valueSource").orElse("Expression").equals("Expression")) {
      return Optional.of(new ActionStep.Assignment(variable, expressions.in(element)));
    }
    String message = "";
    String kind = "";
    for (String name : element.attributeNames()) {
      String lower = name.toLowerCase(Locale.ROOT);
      if (lower.contains("message")) {
        message = element.text(name);
      } else if (lower.contains("type")) {
        kind = element.text(name).toLowerCase(Locale.ROOT);
      }
    }
    Optional<InputKind> asked = inputKind(kind);
    return asked.isEmpty()
        ? Optional.empty()
        : Optional.of(new ActionStep.OperatorInput(variable, asked.get(), message));
  }

  private static Optional<InputKind> inputKind(String text) {
    if (text.contains("bool")) {
      return Optional.of(InputKind.BOOLEAN);
    }
    if (text.contains("int")) {
      return Optional.of(InputKind.INTEGER);
    }
    if (text.contains("float")) {
      return Optional.of(InputKind.FLOAT);
    }
    return text.contains("text") || text.contains("string")
        ? Optional.of(InputKind.TEXT)
        : Optional.empty();
  }

  private Optional<Step> call(XmlElement element) throws UnreadableFile {
    Optional<XmlElement> called = element.child("subprogram", "SubProgram");
    return Optional.of(new ActionStep.Call(called.isEmpty() ? "" : expressions.name(called.get())));
  }

  private Optional<Step> script(XmlElement element) throws UnreadableFile {
    List<String> cached = lines(element.child("cachedContents").map(XmlElement::text).orElse(""));
    return switch (element.text("type")) {
      case "Line" -> Optional.of(new ActionStep.ScriptLine(expressions.in(element)));
      case "File", "Code" -> {
        String file = element.child("file").map(XmlElement::text).orElse("");
        element.child("file").ifPresent(XmlElement::seeAll);
        yield Optional.of(new ActionStep.ScriptFile(file, cached));
      }
      default -> Optional.empty();
    };
  }

  private static List<String> lines(String text) {
    if (text.isEmpty()) {
      return List.of();
    }
    String whole = text.endsWith("\n") ? text.substring(0, text.length() - 1) : text;
    return List.of(whole.split("\n", -1));
  }

  private Optional<Step> timer(XmlElement element) throws UnreadableFile {
    String name = expressions.variable(element);
    return switch (element.text("action").toLowerCase(Locale.ROOT)) {
      case "start" -> Optional.of(new ActionStep.Timer(name, TimerAction.START));
      case "stop" -> Optional.of(new ActionStep.Timer(name, TimerAction.STOP));
      case "reset" -> Optional.of(new ActionStep.Timer(name, TimerAction.RESET));
      default -> Optional.empty();
    };
  }
}
