package org.pendant.language.service;

import static org.pendant.language.service.ServiceTexts.text;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import org.pendant.language.parse.Lexeme.Kind;

/** Keywords and patterns of the language that fit a place. */
final class Keywords {
  /** Marks the caret in a pattern. */
  static final char CARET = '|';

  private static final List<String> VALUES = List.of("True", "False", "None", "not");
  private static final List<String> OPERATORS = List.of("and", "or", "xor");
  private static final List<String> STATEMENTS =
      List.of(
          "return",
          "local",
          "global",
          "join",
          "kill",
          "halt",
          "pause",
          "enter_critical",
          "exit_critical");

  /** The language has no such word: this is what stands for it. */
  private static final String SWITCH =
      "choice = |\nif choice == 0:\n  \nelif choice == 1:\n  \nelse:\n  \nend";

  private Keywords() {}

  /**
   * A word, or a pattern of several lines.
   *
   * @param label what is typed to get it
   * @param pattern the text with the caret's mark in it, its lines indented from column 0
   */
  record Offer(String label, String description, String pattern) {
    boolean isSnippet() {
      return pattern.indexOf('\n') >= 0;
    }

    private static Offer word(String word) {
      return new Offer(word, "", word + CARET);
    }
  }

  static List<Offer> values() {
    List<Offer> offers = new ArrayList<>(VALUES.stream().map(Offer::word).toList());
    offers.add(new Offer("run", text("startsThread"), "run |"));
    return offers;
  }

  static List<Offer> operators() {
    return OPERATORS.stream().map(Offer::word).toList();
  }

  /** What may begin a statement at {@code offset}, given the blocks that are open there. */
  static List<Offer> statements(Lexemes lexemes, int offset) {
    Deque<String> open = openBlocks(lexemes, offset);
    List<Offer> offers = new ArrayList<>();
    offers.add(new Offer("def", text("function"), "def name|():\n  \nend"));
    offers.add(new Offer("thread", text("thread"), "thread name|():\n  \nend"));
    if (open.isEmpty()) {
      offers.add(new Offer("sec", text("secondaryProgram"), "sec name|():\n  \nend"));
    }
    offers.add(new Offer("if", text("condition"), "if |:\n  \nend"));
    offers.add(new Offer("ifelse", text("conditionWithElse"), "if |:\n  \nelse:\n  \nend"));
    offers.add(new Offer("while", text("loop"), "while |:\n  \nend"));
    offers.add(new Offer("switch", text("choiceByValue"), SWITCH));
    offers.add(new Offer("run", text("startsThread"), "run |"));
    STATEMENTS.forEach(word -> offers.add(Offer.word(word)));
    if (!open.isEmpty()) {
      offers.add(Offer.word("end"));
    }
    if ("if".equals(open.peek())) {
      offers.add(new Offer("elif", "", "elif |:"));
      offers.add(new Offer("else", "", "else:|"));
    }
    boolean loop = open.stream().takeWhile(Keywords::isNoDefinition).anyMatch("while"::equals);
    if (loop) {
      offers.add(Offer.word("break"));
      offers.add(Offer.word("continue"));
    }
    return offers;
  }

  private static boolean isNoDefinition(String opener) {
    return opener.equals("if") || opener.equals("while");
  }

  /** The words that opened the blocks around {@code offset}, innermost first. */
  private static Deque<String> openBlocks(Lexemes lexemes, int offset) {
    Deque<String> open = new ArrayDeque<>();
    for (int i = 0; i < lexemes.size() && lexemes.get(i).end() < offset; i++) {
      if (lexemes.is(i, Kind.OPENER)) {
        open.push(lexemes.text(i));
      } else if (lexemes.is(i, Kind.END)) {
        open.poll();
      }
    }
    return open;
  }
}
