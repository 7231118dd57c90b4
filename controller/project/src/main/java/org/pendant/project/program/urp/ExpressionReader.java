package org.pendant.project.program.urp;

import java.util.Map;
import java.util.Optional;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.polyscope.xml.XmlElement;
import org.pendant.project.program.TreeNames;

/**
 * Expression reader: reads expressions, which files keep as rows of single characters, tokens and
 * names.
 */
final class ExpressionReader {
  /** Names the feature that a variable stands for. */
  static final String FEATURE = "featureName";

  /** Signs that only screens have. */
  private static final Map<Integer, String> SIGNS =
      Map.of(
          (int) '\u225f', "==", // equal to, with a question mark
          (int) '\u2254', "=", // becomes
          (int) '\u2260', "!=",
          (int) '\u2264', "<=",
          (int) '\u2265', ">=",
          (int) '\u00d7', "*",
          (int) '\u00f7', "/",
          (int) '\u2212', "-");

  /** Words that only screens have. */
  private static final Map<String, String> WORDS = Map.of("HI", "True", "LO", "False");

  private final UrpSignals signals;
  private final Remarks remarks;

  ExpressionReader(UrpSignals signals, Remarks remarks) {
    this.signals = signals;
    this.remarks = remarks;
  }

  /** The expression in an element of this name; empty if there is none. */
  String in(XmlElement element, String name) throws UnreadableFile {
    Optional<XmlElement> found = element.child(name);
    return found.isEmpty() ? "" : text(found.get());
  }

  /** The expression in the element {@code expression}. */
  String in(XmlElement element) throws UnreadableFile {
    return in(element, "expression");
  }

  private String text(XmlElement carrier) throws UnreadableFile {
    Optional<XmlElement> expression = carrier.resolved();
    if (expression.isEmpty()) {
      remarks.add(carrier, UrpProgramTexts.text("danglingReference", carrier.name()));
      return "";
    }
    StringBuilder text = new StringBuilder(expression.get().text().strip());
    boolean quoted = false;
    for (XmlElement part : expression.get().children()) {
      if (part.name().equals("ExpressionChar")) {
        String character = part.text("character");
        text.append(quoted ? character : plain(character));
        quoted ^= character.equals("\"");
      } else if (part.name().equals("ExpressionToken")) {
        token(part.text("token"), text);
      } else {
        text.append(value(part));
      }
    }
    return text.toString().strip();
  }

  /** Tokens bring blanks along on both sides; one is enough. */
  private static void token(String token, StringBuilder text) {
    String word = token.strip();
    String plain = plain(WORDS.getOrDefault(word, word));
    boolean blankBefore = !token.isEmpty() && token.charAt(0) == ' ';
    if (blankBefore && !text.isEmpty() && text.charAt(text.length() - 1) != ' ') {
      text.append(' ');
    }
    text.append(plain).append(token.length() > 1 && token.endsWith(" ") ? " " : "");
  }

  private static String plain(String text) {
    StringBuilder plain = new StringBuilder();
    text.codePoints()
        .forEach(
            each -> {
              String known = SIGNS.get(each);
              if (known == null) {
                plain.appendCodePoint(each);
              } else {
                plain.append(known);
              }
            });
    return plain.toString();
  }

  private String value(XmlElement part) throws UnreadableFile {
    XmlElement inner = part.children().isEmpty() ? part : part.children().getFirst();
    return switch (part.name()) {
      case "ExpressionIO", "ExpressionPin" -> UrpSignals.expression(signals.named(inner));
      case "ExpressionWaypoint" -> TreeNames.place(name(inner)) + "_p";
      case "ExpressionGeomFeature" -> Features.here(name(inner));
      case "ExpressionVariable" -> word(name(inner));
      default -> {
        remarks.add(part, UrpProgramTexts.text("takenAsName", part.name()));
        yield name(inner);
      }
    };
  }

  /** The name of a variable or the like, wherever it is written in full. */
  String name(XmlElement carrier) throws UnreadableFile {
    Optional<XmlElement> found = carrier.resolved();
    if (found.isEmpty()) {
      remarks.add(
          carrier,
          UrpProgramTexts.text(
              "danglingNamedReference", carrier.text("reference"), carrier.name()));
      return "";
    }
    found.get().child("initializeExpression").ifPresent(XmlElement::seeAll);
    return found
        .get()
        .attribute("name")
        .or(() -> found.get().attribute("referencedName"))
        .or(() -> found.get().attribute(FEATURE))
        .orElseGet(() -> found.get().text().strip());
  }

  /** The name of the variable in an element; empty if there is none. */
  String variable(XmlElement element) throws UnreadableFile {
    Optional<XmlElement> found = element.child("variable", "ProgramVariable", "loopVariable");
    return found.isEmpty() ? "" : word(name(found.get()));
  }

  /** A variable that is called by letters of another language has a name of digits in scripts. */
  static String word(String name) {
    return name.chars().allMatch(each -> each < 128) ? name : TreeNames.word(name, name);
  }
}
