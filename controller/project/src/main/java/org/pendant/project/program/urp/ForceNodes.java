package org.pendant.project.program.urp;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.polyscope.xml.XmlElement;
import org.pendant.project.polyscope.xml.XmlText;
import org.pendant.project.program.Step;
import org.pendant.project.program.TemplateStep;
import org.pendant.project.program.TemplateStep.ForceKind;

/**
 * Force nodes: nodes with force mode. Files have limits of both sorts for each axis: how fast it
 * may give way, and how far it may be off when it does not.
 */
final class ForceNodes {
  static final String ELEMENT = "Force";

  private static final int AXES = 6;
  private static final String COMPLIANT = "selection";
  private static final String WRENCH = "wrench";
  private static final String SPEEDS = "limitsForce";
  private static final String DEVIATIONS = "limitsMotion";

  /** Those of a new node, which stand where they have no meaning. */
  private static final double[] USUAL_SPEEDS = {0.15, 0.15, 0.15, 1.05, 1.05, 1.05};

  private static final double[] USUAL_DEVIATIONS = {0.1, 0.1, 0.1, 0.35, 0.35, 0.35};

  private ForceNodes() {}

  /** The step of an element; empty if it is no whole node of that sort. */
  static Optional<Step> read(XmlElement element, ExpressionReader expressions)
      throws UnreadableFile {
    double[] compliant = row(element, COMPLIANT);
    double[] wrench = row(element, WRENCH);
    double[] speeds = row(element, SPEEDS);
    double[] deviations = row(element, DEVIATIONS);
    Optional<ForceKind> kind =
        Arrays.stream(ForceKind.values())
            .filter(each -> word(each).equals(element.text("type")))
            .findFirst();
    boolean whole =
        List.of(compliant, wrench, speeds, deviations).stream()
            .allMatch(each -> each.length == AXES);
    if (!whole || kind.isEmpty()) {
      return Optional.empty();
    }
    List<Boolean> axes = new ArrayList<>();
    List<Double> limits = new ArrayList<>();
    for (int i = 0; i < AXES; i++) {
      axes.add(compliant[i] != 0);
      limits.add(compliant[i] != 0 ? speeds[i] : deviations[i]);
    }
    return Optional.of(
        new TemplateStep.Force(
            kind.get(),
            Features.in(element, expressions),
            axes,
            Arrays.stream(wrench).boxed().toList(),
            limits));
  }

  private static double[] row(XmlElement element, String name) {
    return Values.numbers(element.child(name).map(each -> each.text("value")).orElse(""));
  }

  /**
   * Begins the element of a step.
   *
   * @return whether there is one; if not, nothing was written
   */
  static boolean open(TemplateStep.Force force, XmlText out) {
    boolean whole =
        force.compliant().size() == AXES
            && force.wrench().size() == AXES
            && force.limits().size() == AXES;
    if (!whole) {
      return false;
    }
    int[] compliant = new int[AXES];
    double[] speeds = USUAL_SPEEDS.clone();
    double[] deviations = USUAL_DEVIATIONS.clone();
    for (int i = 0; i < AXES; i++) {
      boolean gives = force.compliant().get(i);
      compliant[i] = gives ? 1 : 0;
      (gives ? speeds : deviations)[i] = force.limits().get(i);
    }
    out.open(ELEMENT, "type", word(force.kind()));
    out.leaf("feature", "referencedName", Features.there(force.feature()));
    out.leaf(
        COMPLIANT,
        "value",
        Arrays.stream(compliant).mapToObj(Integer::toString).collect(Collectors.joining(", ")));
    row(out, WRENCH, force.wrench().stream().mapToDouble(Double::doubleValue).toArray());
    row(out, SPEEDS, speeds);
    row(out, DEVIATIONS, deviations);
    return true;
  }

  private static void row(XmlText out, String name, double[] values) {
    out.leaf(name, "value", Values.text(values));
  }

  /** As files call it: {@code Simple}, {@code Frame}, {@code Point}, {@code Motion}. */
  private static String word(ForceKind kind) {
    return kind.name().charAt(0) + kind.name().substring(1).toLowerCase(Locale.ROOT);
  }
}
