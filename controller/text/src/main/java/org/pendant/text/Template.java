package org.pendant.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A text with places for values, taken apart.
 *
 * @param pieces what stands before the first place, between two, and after the last one
 * @param places as many as there are pieces, less one
 */
record Template(List<String> pieces, List<ValuePlace> places) {
  private static final Pattern PLACE = Pattern.compile("\\{(\\d)(\\*?)}");

  static Template of(String text) {
    List<String> pieces = new ArrayList<>();
    List<ValuePlace> places = new ArrayList<>();
    Matcher place = PLACE.matcher(text);
    int from = 0;
    while (place.find()) {
      pieces.add(text.substring(from, place.start()));
      places.add(new ValuePlace(Integer.parseInt(place.group(1)), !place.group(2).isEmpty()));
      from = place.end();
    }
    pieces.add(text.substring(from));
    return new Template(List.copyOf(pieces), List.copyOf(places));
  }

  /** How much of it is fixed, characters. */
  int weight() {
    return pieces.stream().mapToInt(String::length).sum();
  }

  /**
   * Whether messages made of it can be told from others: it has a word, and no two places touch.
   */
  boolean isRecognisable() {
    boolean apart = pieces.stream().skip(1).limit(places.size() - 1L).noneMatch(String::isEmpty);
    return apart && pieces.stream().anyMatch(each -> each.chars().anyMatch(Character::isLetter));
  }

  /** Which of its places takes the value of a number; negative if none. */
  int indexOf(int number) {
    for (int i = 0; i < places.size(); i++) {
      if (places.get(i).number() == number) {
        return i;
      }
    }
    return -1;
  }

  /** The values at its places in a message that was made of it; empty if it was not. */
  Optional<List<String>> valuesIn(String message) {
    String first = pieces.getFirst();
    String last = pieces.getLast();
    int end = message.length() - last.length();
    if (end < first.length() || !message.startsWith(first) || !message.endsWith(last)) {
      return Optional.empty();
    }
    List<String> values = new ArrayList<>(places.size());
    int from = first.length();
    for (int i = 1; i < places.size(); i++) {
      int at = message.indexOf(pieces.get(i), from);
      if (at < 0 || at + pieces.get(i).length() > end) {
        return Optional.empty();
      }
      values.add(message.substring(from, at));
      from = at + pieces.get(i).length();
    }
    values.add(message.substring(from, end));
    return agree(values) ? Optional.of(values) : Optional.empty();
  }

  /** Whether places of one number have one value. */
  private boolean agree(List<String> values) {
    for (int i = 0; i < places.size(); i++) {
      if (!values.get(indexOf(places.get(i).number())).equals(values.get(i))) {
        return false;
      }
    }
    return true;
  }
}
