package org.pendant.desktop.editor.text;

import static org.pendant.desktop.editor.text.ScriptTexts.text;

import java.util.List;

/**
 * Find state: where a search stands.
 *
 * @param query what is looked for
 * @param matches where it stands in the text, in order
 */
public record FindState(SearchQuery query, List<TextSpan> matches) {
  /** Nothing is looked for. */
  public static final FindState NONE = new FindState(SearchQuery.NONE, List.of());

  public FindState {
    matches = List.copyOf(matches);
  }

  /** Looks for {@code query} in {@code text}. */
  public static FindState of(SearchQuery query, CharSequence text) {
    return new FindState(query, query.in(text));
  }

  /**
   * The number of the first match that begins at or behind {@code offset}, round the end; or -1.
   */
  public int from(int offset) {
    for (int i = 0; i < matches.size(); i++) {
      if (matches.get(i).start() >= offset) {
        return i;
      }
    }
    return matches.isEmpty() ? -1 : 0;
  }

  /** The number of the last match that begins before {@code offset}, round the start; or -1. */
  public int before(int offset) {
    for (int i = matches.size() - 1; i >= 0; i--) {
      if (matches.get(i).start() < offset) {
        return i;
      }
    }
    return matches.size() - 1;
  }

  /** What the bar says: how many there are, and which is selected, or what is wrong. */
  public String summary(TextSpan selected) {
    if (query.words().isEmpty()) {
      return "";
    }
    String complaint = query.complaint();
    if (!complaint.isEmpty()) {
      return complaint;
    }
    if (matches.isEmpty()) {
      return text("noMatch");
    }
    boolean more = matches.size() >= SearchQuery.MAX_MATCHES;
    int index = matches.indexOf(selected);
    if (index >= 0) {
      return text(more ? "matchOfOrMore" : "matchOf", index + 1, matches.size());
    }
    return text(
        more ? "matchesOrMore" : matches.size() == 1 ? "oneMatch" : "matches", matches.size());
  }

  /**
   * The edits that replace every match.
   *
   * @throws IllegalArgumentException if the replacement names a group that there is not
   */
  public List<Edit> replaceAll(CharSequence text, String replacement) {
    return matches.stream().map(match -> query.replacement(text, match, replacement)).toList();
  }
}
