package org.pendant.text;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * Says in another language what packages have said in English. What runs and what is written into
 * files speaks English whatever the language of the computer, so that logs, recordings, reports and
 * what goes out on ports are the same everywhere; what shows it to people asks here.
 *
 * <p>A message is recognised by the English text that it was made from: the fixed pieces of that
 * text stand in it in their order, and what is between them are the values. Of several texts that
 * fit, the one that leaves least to values is taken. A place {@code {0*}} in a translation takes a
 * value that is a text itself, such as the name of a joint or a sentence within a sentence, and
 * says that in the other language too; one without the star takes it as it is. What stands before
 * {@code ": "}, as a file or a place does, and sentences between {@code "; "} are looked at by
 * themselves where no text has them together.
 */
public final class Translations {
  /** Characters of a message that is looked at: those of clients may be as long as they like. */
  static final int MAX_LENGTH = 4000;

  /** Texts within texts that are followed. */
  private static final int MAX_DEPTH = 4;

  /** Times that a message, or a part of it, is compared with all texts. */
  private static final int MAX_READINGS = 100;

  private static final Pattern SENTENCE = Pattern.compile("[a-z]+ [a-z]+ [a-z]+");

  private final Map<String, String> plain;
  private final List<Translated> filled;
  private final Joining joining;

  private Translations(Map<String, String> plain, List<Translated> filled, Joining joining) {
    this.plain = plain;
    this.filled = filled;
    this.joining = joining;
  }

  /** A text with places, and what it is in the other language. */
  private record Translated(Template english, Template other) {}

  /**
   * Those of some bundles.
   *
   * @param loader finds their files
   * @param bundles their names, such as {@code controller.safety}; where two say the same in
   *     English, the first says it in the other language; those of modules that are not there are
   *     left out
   */
  public static Translations of(Language language, ClassLoader loader, Collection<String> bundles) {
    Map<String, String> plain = new HashMap<>();
    List<Translated> filled = new ArrayList<>();
    if (language != Language.ENGLISH) {
      for (String bundle : bundles) {
        Map<String, String> english = read(loader, bundle);
        Map<String, String> translated = read(loader, bundle + "_" + language.code());
        for (String key : english.keySet().stream().sorted().toList()) {
          String text = english.get(key);
          String translation = translated.getOrDefault(key, text);
          Template template = Template.of(text);
          if (template.places().isEmpty()) {
            plain.putIfAbsent(text, translation);
          } else if (template.isRecognisable()) {
            filled.add(new Translated(template, Template.of(translation)));
          }
        }
      }
    }
    filled.sort(Comparator.comparingInt(each -> -each.english().weight()));
    return new Translations(plain, filled, Joining.of(language));
  }

  private static Map<String, String> read(ClassLoader loader, String bundle) {
    Map<String, String> texts = new HashMap<>();
    Texts.read(bundle, loader::getResourceAsStream, texts);
    return texts;
  }

  /**
   * A message in the other language. What no text is recognised in stays as it is; of several lines
   * each is then looked at by itself. One of more than {@link #MAX_LENGTH} characters stays.
   */
  public String of(String message) {
    return message.length() > MAX_LENGTH ? message : new Reading().said(message, 0).text();
  }

  /**
   * A message in the other language.
   *
   * @param values how much of it no text accounts for, characters
   */
  private record Said(String text, int values) {}

  private static Said better(Optional<Said> other, Said than) {
    return other.filter(each -> each.values() < than.values()).orElse(than);
  }

  /**
   * Whether a message that fits a text like {@code {0} is {1}} has a sentence where that has a name
   * or a number: it was made of another text, which is not known here.
   */
  private static boolean beginsLikeAnother(Translated text, List<String> values) {
    boolean first = text.english().pieces().getFirst().isEmpty();
    int number = text.english().places().getFirst().number();
    boolean known =
        text.other().places().stream().anyMatch(each -> each.number() == number && each.isText());
    return first && !known && SENTENCE.matcher(values.getFirst()).find();
  }

  /**
   * The reading of one message, in which texts within texts are looked at so many times at most.
   */
  private final class Reading {
    private int readings = MAX_READINGS;

    private Said said(String message, int depth) {
      String translation = plain.get(message);
      if (translation != null) {
        return new Said(translation, 0);
      }
      Said best = new Said(message, message.length());
      if (depth == MAX_DEPTH || --readings < 0) {
        return best;
      }
      for (Translated each : filled) {
        Optional<List<String>> values = each.english().valuesIn(message);
        if (values.isPresent() && !beginsLikeAnother(each, values.get())) {
          Said other = said(each, values.get(), depth);
          best = other.values() < best.values() ? other : best;
        }
      }
      best = better(ofSentences(message, depth), best);
      best = better(ofPlace(message, depth), best);
      return best.values() < message.length() || message.indexOf('\n') < 0
          ? best
          : ofLines(message, depth);
    }

    private Optional<Said> ofSentences(String message, int depth) {
      int end = message.indexOf("; ");
      if (end < 0) {
        return Optional.empty();
      }
      Said first = said(message.substring(0, end), depth + 1);
      Said rest = said(message.substring(end + 2), depth + 1);
      return Optional.of(
          new Said(first.text() + "; " + rest.text(), first.values() + 2 + rest.values()));
    }

    /**
     * A text behind what it is about or who says it, such as {@code robot.json:3: the end is
     * missing} or {@code gripper: part lost}.
     */
    private Optional<Said> ofPlace(String message, int depth) {
      int end = message.indexOf(": ");
      if (end < 0) {
        return Optional.empty();
      }
      String place = message.substring(0, end);
      Said rest = said(message.substring(end + 2), depth + 1);
      return Optional.of(
          new Said(plain.getOrDefault(place, place) + ": " + rest.text(), end + 2 + rest.values()));
    }

    private Said said(Translated text, List<String> values, int depth) {
      Template other = text.other();
      StringBuilder said = new StringBuilder(other.pieces().getFirst());
      int left = 0;
      for (int i = 0; i < other.places().size(); i++) {
        ValuePlace place = other.places().get(i);
        int at = text.english().indexOf(place.number());
        String value = at < 0 ? "" : values.get(at);
        Said put = place.isText() ? said(value, depth + 1) : new Said(value, value.length());
        joining.append(said, put.text());
        joining.append(said, other.pieces().get(i + 1));
        left += put.values();
      }
      return new Said(said.toString(), left);
    }

    private Said ofLines(String message, int depth) {
      StringBuilder said = new StringBuilder();
      int left = 0;
      int from = 0;
      while (from < message.length()) {
        int end = message.indexOf('\n', from);
        int next = end < 0 ? message.length() : end + 1;
        Said line = said(message.substring(from, end < 0 ? next : end), depth + 1);
        said.append(line.text()).append(end < 0 ? "" : "\n");
        left += line.values();
        from = next;
      }
      return new Said(said.toString(), left);
    }
  }
}
