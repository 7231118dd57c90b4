package org.pendant.project.program.urp;

import java.util.Locale;
import java.util.Optional;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.polyscope.xml.XmlElement;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.LoopRule;
import org.pendant.project.program.Step;

/** Flow reader: understands the elements that decide what runs, or how what is below them runs. */
final class FlowReader {
  /** The value of what runs when no case fits. */
  static final String DEFAULT_CASE = Integer.toString(Integer.MAX_VALUE);

  private final ExpressionReader expressions;

  FlowReader(ExpressionReader expressions) {
    this.expressions = expressions;
  }

  /** The step of an element; empty if it is none of these. */
  Optional<Step> step(XmlElement element) throws UnreadableFile {
    return switch (SwitchedOff.kind(element)) {
      case "If" -> branch(element);
      case "Loop" -> loop(element).map(FlowStep.Loop::new);
      case "Switch" -> Optional.of(new FlowStep.Switch(expressions.in(element)));
      case "Case" -> Optional.of(caseOf(element));
      case ForceNodes.ELEMENT -> ForceNodes.read(element, expressions);
      case "DefaultCase", "Default" -> Optional.of(new FlowStep.DefaultCase());
      default -> Optional.empty();
    };
  }

  private Optional<Step> branch(XmlElement element) throws UnreadableFile {
    String condition = expressions.in(element);
    boolean continuously = Values.yes(element, "checkContinuously");
    return switch (element.attribute("type").orElse("If")) {
      case "If" -> Optional.of(new FlowStep.If(condition, continuously));
      case "ElseIf" -> Optional.of(new FlowStep.ElseIf(condition, continuously));
      case "Else" -> Optional.of(new FlowStep.Else());
      default -> Optional.empty();
    };
  }

  private Optional<LoopRule> loop(XmlElement element) throws UnreadableFile {
    String condition = expressions.in(element);
    boolean continuously = Values.yes(element, "checkContinuously");
    return switch (element.text("type")) {
      case "Forever" -> Optional.of(new LoopRule.Forever());
      case "Counting" ->
          Optional.of(
              new LoopRule.Times(
                  element.attribute("count").orElse(condition), expressions.variable(element)));
      case "While" -> Optional.of(new LoopRule.While(condition, continuously));
      default -> Optional.empty();
    };
  }

  private static Step caseOf(XmlElement element) {
    String value = element.text("caseValue");
    return value.equals(DEFAULT_CASE)
            || element.text("type").toLowerCase(Locale.ROOT).equals("default")
        ? new FlowStep.DefaultCase()
        : new FlowStep.Case(value);
  }
}
