package org.pendant.project.program.urp;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.Collectors;
import org.pendant.project.polyscope.xml.XmlElement;

/** Value reader: reads numbers and the like; what cannot be one counts as missing. */
final class Values {
  private static final Set<String> YES = Set.of("true", "1", "yes", "hi", "high", "on");

  private Values() {}

  /** A number; not finite ones are none. */
  static OptionalDouble number(String text) {
    try {
      double number = Double.parseDouble(text.strip());
      return Double.isFinite(number) ? OptionalDouble.of(number) : OptionalDouble.empty();
    } catch (NumberFormatException e) {
      return OptionalDouble.empty();
    }
  }

  /** The number in an attribute. */
  static OptionalDouble attribute(XmlElement element, String name) {
    return number(element.text(name));
  }

  /** The number in an attribute, or in an element of that name. */
  static OptionalDouble either(XmlElement element, String name) {
    Optional<XmlElement> child = element.child(name);
    return number(element.attribute(name).or(() -> child.map(XmlElement::text)).orElse(""));
  }

  /** Whether an attribute, or an element of that name, says yes. */
  static boolean yes(XmlElement element, String name) {
    Optional<XmlElement> child = element.child(name);
    String text = element.attribute(name).or(() -> child.map(XmlElement::text)).orElse("");
    return YES.contains(text.strip().toLowerCase(Locale.ROOT));
  }

  /** Numbers with commas between. */
  static String text(double... numbers) {
    return Arrays.stream(numbers).mapToObj(Double::toString).collect(Collectors.joining(", "));
  }

  /** Numbers with commas between; none if one of them is not a number. */
  static double[] numbers(String text) {
    double[] numbers =
        Arrays.stream(text.split(",", -1))
            .mapToDouble(each -> number(each).orElse(Double.NaN))
            .toArray();
    return Arrays.stream(numbers).allMatch(Double::isFinite) ? numbers : new double[0];
  }
}
