package org.pendant.language.service;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import org.pendant.language.parse.Lexeme;
import org.pendant.language.source.SourceRange;

/** Block words: finds the words that belong to one block, {@code if ... elif ... else ... end}. */
final class BlockWords {
  private BlockWords() {}

  /** Those of the block whose word is at {@code offset} or ends there; none at other places. */
  static List<SourceRange> at(Lexemes lexemes, int offset) {
    Deque<List<SourceRange>> open = new ArrayDeque<>();
    for (int i = 0; i < lexemes.size(); i++) {
      Lexeme lexeme = lexemes.get(i);
      switch (lexeme.kind()) {
        case OPENER -> open.push(new ArrayList<>(List.of(lexeme.range())));
        case ALTERNATIVE -> {
          if (!open.isEmpty()) {
            open.peek().add(lexeme.range());
          }
        }
        case END -> {
          if (!open.isEmpty()) {
            List<SourceRange> block = open.pop();
            block.add(lexeme.range());
            if (touches(block, offset)) {
              return List.copyOf(block);
            }
          }
        }
        default -> {}
      }
    }
    return List.of();
  }

  private static boolean touches(List<SourceRange> block, int offset) {
    return block.stream().anyMatch(word -> word.start() <= offset && offset <= word.end());
  }
}
