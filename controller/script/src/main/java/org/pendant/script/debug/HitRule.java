package org.pendant.script.debug;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Hit rule: which hits on a breakpoint count, of those with a true condition.
 *
 * @param number at least 1
 */
public record HitRule(Kind kind, int number) {
  /** All of them. */
  public static final HitRule ALWAYS = from(1);

  private static final Pattern FORM =
      Pattern.compile("\\s*(>=|>|<=|<|={1,3}|%|)\\s*([1-9]\\d{0,8})\\s*");

  /** How the number is meant. */
  public enum Kind {
    /** This hit and all after it. */
    FROM,
    /** This hit and all before it. */
    UP_TO,
    /** This hit alone. */
    ONLY,
    /** Each hit whose number it divides. */
    EVERY
  }

  public HitRule {
    if (number < 1) {
      throw new IllegalArgumentException("hit is " + number + ", must be at least 1");
    }
  }

  /** From a hit on. */
  public static HitRule from(int hit) {
    return new HitRule(Kind.FROM, hit);
  }

  /**
   * As people write it: {@code 5} and {@code >= 5} mean the fifth and all after it, {@code == 5}
   * that one, {@code % 5} each fifth, empty text all. Empty for anything else.
   */
  public static Optional<HitRule> of(String text) {
    if (text.isBlank()) {
      return Optional.of(ALWAYS);
    }
    Matcher form = FORM.matcher(text);
    if (!form.matches()) {
      return Optional.empty();
    }
    int number = Integer.parseInt(form.group(2));
    return switch (form.group(1)) {
      case "", ">=" -> Optional.of(from(number));
      case ">" -> Optional.of(from(number + 1));
      case "<=" -> Optional.of(new HitRule(Kind.UP_TO, number));
      case "<" -> number == 1 ? Optional.empty() : Optional.of(new HitRule(Kind.UP_TO, number - 1));
      case "%" -> Optional.of(new HitRule(Kind.EVERY, number));
      default -> Optional.of(new HitRule(Kind.ONLY, number));
    };
  }

  /** What to say of a text that is no rule. */
  public static String forms() {
    return DebuggerTexts.text("forms");
  }

  /** Whether hit {@code hit} counts, from 1. */
  public boolean counts(long hit) {
    return switch (kind) {
      case FROM -> hit >= number;
      case UP_TO -> hit <= number;
      case ONLY -> hit == number;
      case EVERY -> hit % number == 0;
    };
  }

  /** Whether all hits count. */
  public boolean always() {
    return number == 1 && (kind == Kind.FROM || kind == Kind.EVERY);
  }

  /** A text that {@link #of} reads. */
  public String text() {
    return switch (kind) {
      case FROM -> Integer.toString(number);
      case UP_TO -> "<= " + number;
      case ONLY -> "== " + number;
      case EVERY -> "% " + number;
    };
  }

  /** For a sentence about a breakpoint. */
  public String words() {
    return switch (kind) {
      case FROM -> DebuggerTexts.text("fromHit", number);
      case UP_TO -> DebuggerTexts.text("upToHit", number);
      case ONLY -> DebuggerTexts.text("atHitOnly", number);
      case EVERY -> DebuggerTexts.text("atEachHit", number);
    };
  }
}
