package org.pendant.project.program.urp;

import java.util.Optional;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.project.polyscope.xml.XmlElement;

/**
 * Suppressed node: it stands in a wrapper, in the part of what is suppressed, and its class says
 * which node it is.
 */
final class SwitchedOff {
  /** The element around it. */
  static final String WRAPPER = "SuppressedNode";

  /** What the node itself is called there. */
  static final String NAME = "suppressedNode";

  private static final String CLASS = "class";

  private static final Pattern ATTRIBUTE =
      Pattern.compile("\\s+([^\\s=<>/]+)\\s*=\\s*(?:\"[^\"]*\"|'[^']*')");

  private SwitchedOff() {}

  /** What an element is: its name, but for a node that is switched off, whose class says it. */
  static String kind(XmlElement element) {
    return element.name().equals(NAME)
        ? element.attribute(CLASS).orElse(element.name())
        : element.name();
  }

  /** An element to the letter, but as it is called where it is not switched off. */
  static String plain(XmlElement element) {
    String raw = element.raw();
    Optional<MatchResult> kind = attribute(element, CLASS);
    if (!element.name().equals(NAME) || kind.isEmpty()) {
      return raw;
    }
    String rest = raw.substring(1 + NAME.length(), kind.get().start());
    return renamed("<" + kind(element) + rest + raw.substring(kind.get().end()), kind(element));
  }

  /** An element to the letter, but as it is called where it is switched off. */
  static String written(XmlElement element) {
    if (element.name().equals(NAME) || attribute(element, CLASS).isPresent()) {
      return element.raw();
    }
    String rest = element.raw().substring(1 + element.name().length());
    return renamed("<" + NAME + " " + CLASS + "=\"" + element.name() + "\"" + rest, NAME);
  }

  /** With another name in its last tag, which an empty element does not have. */
  private static String renamed(String raw, String name) {
    int last = raw.lastIndexOf("</") + 2;
    return raw.endsWith("/>")
        ? raw
        : raw.substring(0, last) + name + raw.substring(last).replaceFirst("^[^\\s>]+", "");
  }

  /** Where an attribute stands in the first tag, with the blanks before it. */
  private static Optional<MatchResult> attribute(XmlElement element, String name) {
    String raw = element.raw();
    Matcher next = ATTRIBUTE.matcher(raw);
    int at = 1 + element.name().length();
    while (next.region(at, raw.length()).lookingAt()) {
      if (next.group(1).equals(name)) {
        return Optional.of(next.toMatchResult());
      }
      at = next.end();
    }
    return Optional.empty();
  }
}
