package org.pendant.language.parse;

import java.util.List;
import java.util.Optional;
import org.antlr.v4.runtime.TokenSource;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;

/**
 * Text change: in which lines two versions of a text differ, and the tokens and lexemes of the
 * newer one: no token goes over a line end, so that only lines that differ are read, and those
 * behind up to where the token pass is in the state in which it was before.
 *
 * @param sameBefore the offset of the line up to which both texts are the same
 * @param sameFrom the offset in the newer text from which on its tokens are those of the older one;
 *     beyond its end if none are
 * @param shift how far these have moved
 * @param maker made the tokens that were read
 */
record TextChange(
    TokenTable tokens,
    LexemeTable lexemes,
    int sameBefore,
    int sameFrom,
    int shift,
    TokenSource maker) {

  /** What has become of {@code before}; empty if the newer text has to be read as a whole. */
  static Optional<TextChange> of(ReadText before, Source newer) {
    if (before.tokens().isEmpty()) {
      return Optional.empty();
    }
    String oldText = before.result().script().source().text();
    String text = newer.text();
    int shift = text.length() - oldText.length();
    int shorter = Math.min(text.length(), oldText.length());
    int equal = sameBytes(oldText, text, shorter);
    int line = text.lastIndexOf('\n', equal - 1) + 1;
    int equalBehind = sameEnd(oldText, text, shorter - equal);
    int lineEnd = text.indexOf('\n', text.length() - equalBehind);
    int equalFrom = lineEnd < 0 ? Integer.MAX_VALUE : lineEnd + 1;

    TokenTable earlier = before.tokens().get();
    int from = earlier.indexAt(line);
    TokenPass pass = new TokenPass(newer, earlier, from, line);
    int to = pass.readUntil(earlier, equalFrom, shift);
    if (pass.tooDeep().isPresent()) {
      return Optional.empty();
    }
    TokenTable tokens = earlier.with(from, to, pass.tokens(), shift);
    if (tokens.deepest() > TokenPass.MAX_BLOCKS) {
      return Optional.empty();
    }
    LexemeTable old = before.lexemes();
    int behind = to < earlier.size() ? old.indexAt(earlier.start(to)) : old.size();
    return Optional.of(
        new TextChange(
            tokens,
            old.with(old.indexAt(line), behind, pass.lexemes().orElseThrow(), shift),
            line,
            to < earlier.size() ? earlier.start(to) + shift : Integer.MAX_VALUE,
            shift,
            pass.lexer()));
  }

  private static int sameBytes(String one, String other, int most) {
    int at = 0;
    while (at < most && one.charAt(at) == other.charAt(at)) {
      at++;
    }
    return at;
  }

  private static int sameEnd(String one, String other, int most) {
    int count = 0;
    while (count < most
        && one.charAt(one.length() - 1 - count) == other.charAt(other.length() - 1 - count)) {
      count++;
    }
    return count;
  }

  /** A range of the older text as it is in the newer one, at least. */
  private SourceRange moved(SourceRange old) {
    int start = old.start() < sameBefore ? old.start() : sameBefore;
    int end = old.end() < sameBefore ? old.end() : Math.min(sameFrom, tokens.end());
    if (isBehind(old.start())) {
      start = old.start() + shift;
    }
    if (isBehind(old.end())) {
      end = old.end() + shift;
    }
    return new SourceRange(start, Math.max(start, end));
  }

  private boolean isBehind(int oldOffset) {
    return sameFrom != Integer.MAX_VALUE && oldOffset >= sameFrom - shift;
  }

  /** Where the older text was not read plainly. */
  List<SourceRange> moved(List<SourceRange> old) {
    return old.stream().map(this::moved).toList();
  }
}
