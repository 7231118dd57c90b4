package org.pendant.protocols.wire;

import static org.pendant.protocols.wire.WireTexts.text;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;

/**
 * Reading: what a message says.
 *
 * @param type one word or a few with dashes, such as {@code setup-outputs}
 * @param summary one line
 * @param quoted whether the summary is what a peer has written, and no text about it
 * @param effect what it does to robot, program or registers, as a short text; empty for a message
 *     that asks or tells
 * @param fields its parts by their names: numbers, truth values, texts, and lists of these; made
 *     when asked for, since most messages are passed over
 */
public record Reading(
    String type,
    String summary,
    boolean quoted,
    Optional<String> effect,
    Supplier<? extends Map<String, ?>> fields) {

  /** Most characters of a summary. */
  public static final int MAX_SUMMARY = 240;

  /** Cuts the summary. */
  public Reading {
    summary = line(summary);
    effect = effect.map(Reading::line);
  }

  /** Of a message without an effect. */
  public static Reading of(String type, String summary, Supplier<? extends Map<String, ?>> fields) {
    return new Reading(type, summary, false, Optional.empty(), fields);
  }

  /** Of a message that is a text, as its peer has written it. */
  public static Reading quoting(
      String type, String text, Supplier<? extends Map<String, ?>> fields) {
    return new Reading(type, text, true, Optional.empty(), fields);
  }

  /** Of a message that says no more than its type and summary. */
  public static Reading of(String type, String summary) {
    return of(type, summary, Map::of);
  }

  /** The same with an effect. */
  public Reading doing(String what) {
    return new Reading(type, summary, quoted, Optional.of(what), fields);
  }

  /** The same without an effect. */
  public Reading doingNothing() {
    return new Reading(type, summary, quoted, Optional.empty(), fields);
  }

  /** The same with other parts. */
  public Reading withFields(Supplier<? extends Map<String, ?>> parts) {
    return new Reading(type, summary, quoted, effect, parts);
  }

  /** Names with commas between, and how many there are where they are many. */
  public static String names(List<String> names) {
    int most = 6;
    String first = String.join(", ", names.subList(0, Math.min(most, names.size())));
    return names.size() > most ? text("andMore", first, names.size() - most) : first;
  }

  private static String line(String text) {
    String shown = text.length() > MAX_SUMMARY ? text.substring(0, MAX_SUMMARY) + "\u2026" : text;
    return shown.chars().anyMatch(each -> each < ' ' || each == 0x7F)
        ? shown.replaceAll("[\\x00-\\x1f\\x7f]+", " ")
        : shown;
  }
}
