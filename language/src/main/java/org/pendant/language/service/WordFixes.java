package org.pendant.language.service;

import static org.pendant.language.service.ServiceTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.pendant.language.parse.Lexeme;
import org.pendant.language.parse.Lexeme.Kind;
import org.pendant.language.source.Diagnostic;

/** Fixes for single words and signs, habits of other languages mostly. */
final class WordFixes {
  private final Lexemes lexemes;
  private final int at;
  private final int start;
  private final int end;
  private final String found;

  private WordFixes(Lexemes lexemes, int at) {
    this.lexemes = lexemes;
    this.at = at;
    this.start = lexemes.get(at).start();
    this.end = lexemes.get(at).end();
    this.found = lexemes.text(at);
  }

  static List<QuickFix> propose(ScriptAnalysis analysis, Diagnostic diagnostic) {
    int at = analysis.lexemes().at(diagnostic.range().start());
    if (at < 0) {
      return List.of();
    }
    WordFixes fixes = new WordFixes(analysis.lexemes(), at);
    return switch (diagnostic.code()) {
      case "semicolon" -> fixes.replace(text("remove", ";"), "");
      case "comment" ->
          List.of(QuickFix.replace(text("write", "#"), fixes.start, fixes.start + 2, "#"));
      case "single-quotes" -> fixes.doubleQuotes();
      case "unclosed-string" -> fixes.closedString();
      case "and-sign" -> fixes.word("and");
      case "or-sign" -> fixes.word("or");
      case "unequal-sign" -> fixes.replaceBy("!=");
      case "colon-assign" -> fixes.replaceBy("=");
      case "arithmetic-assign" -> fixes.arithmetic();
      case "else-if" -> fixes.elseIf();
      case "end-word" -> fixes.replaceBy("end");
      case "function-word" -> fixes.replaceBy("def");
      case "word-case" -> fixes.replaceBy(fixes.found.toLowerCase(Locale.ROOT));
      case "syntax-error" -> fixes.sign();
      default -> List.of();
    };
  }

  private List<QuickFix> replace(String title, String text) {
    return List.of(QuickFix.replace(title, start, end, text));
  }

  private List<QuickFix> replaceBy(String text) {
    return replace(text("replaceByWord", text), text);
  }

  /** A word in place of a sign, which may have stood without blanks around it. */
  private List<QuickFix> word(String word) {
    String text = lexemes.source().text();
    String before = text.startsWith(" ", start - 1) ? "" : " ";
    String after = text.startsWith(" ", end) ? "" : " ";
    return replace(text("replaceByWord", word), before + word + after);
  }

  private List<QuickFix> doubleQuotes() {
    String inner = found.substring(1, found.length() - 1);
    return inner.indexOf('"') >= 0
        ? List.of()
        : replace(text("writeDoubleQuotes"), "\"" + inner + "\"");
  }

  /** In front of the brackets that the open string has swallowed, or at the end of the line. */
  private List<QuickFix> closedString() {
    int inner = found.length();
    while (inner > 1 && ")]: \t".indexOf(found.charAt(inner - 1)) >= 0) {
      inner--;
    }
    QuickFix beforeBrackets = QuickFix.insert(text("closeString"), start + inner, "\"");
    QuickFix atEnd = QuickFix.insert(text("closeStringAtLineEnd"), end, "\"");
    return inner == found.length() ? List.of(atEnd) : List.of(beforeBrackets, atEnd);
  }

  /** {@code x += 1} to {@code x = x + 1}, with brackets where the right side needs them. */
  private List<QuickFix> arithmetic() {
    int first = at - 1;
    while (first > 0 && !lexemes.get(first).firstOnLine()) {
      first--;
    }
    int last = at;
    boolean operators = false;
    while (last + 1 < lexemes.size()
        && !lexemes.get(last + 1).firstOnLine()
        && !lexemes.is(last + 1, Kind.COMMENT)) {
      last++;
      operators |= lexemes.is(last, Kind.OPERATOR);
    }
    if (first < 0 || last == at) {
      return List.of();
    }
    String text = lexemes.source().text();
    String target = text.substring(lexemes.get(first).start(), lexemes.get(at - 1).end());
    String begin = "= " + target + " " + found.charAt(0) + (operators ? " (" : "");
    List<TextEdit> edits = new ArrayList<>();
    edits.add(TextEdit.replace(start, end, begin));
    if (operators) {
      int value = lexemes.get(at + 1).start();
      edits.set(0, TextEdit.replace(start, value, begin));
      edits.add(TextEdit.insert(lexemes.get(last).end(), ")"));
    }
    return List.of(
        new QuickFix(
            text("write", target + " = " + target + " " + found.charAt(0) + " ..."), edits));
  }

  private List<QuickFix> elseIf() {
    boolean two = lexemes.reads(at, "else") && lexemes.reads(at + 1, "if");
    int until = two ? lexemes.get(at + 1).end() : end;
    return List.of(QuickFix.replace(text("replaceByWord", "elif"), start, until, "elif"));
  }

  /** What the parser stumbled over may be a comparison, an increment or two strings. */
  private List<QuickFix> sign() {
    List<QuickFix> fixes = new ArrayList<>();
    Lexeme lexeme = lexemes.get(at);
    if (lexeme.kind() == Kind.ASSIGN) {
      fixes.addAll(replace(text("compareWith"), "=="));
    } else if (found.equals("==")) {
      fixes.addAll(replace(text("assignWith"), "="));
    } else if (lexeme.kind() == Kind.STRING && lexemes.is(at - 1, Kind.STRING)) {
      fixes.add(QuickFix.insert(text("joinStrings"), start, "+ "));
    } else if (lexeme.kind() == Kind.CLOSE) {
      fixes.addAll(replace(text("remove", found), ""));
    } else {
      increment(fixes);
    }
    return fixes;
  }

  private void increment(List<QuickFix> fixes) {
    for (int name = at - 2; name <= at - 1; name++) {
      boolean twice = lexemes.reads(name + 1, "+") && lexemes.reads(name + 2, "+");
      boolean less = lexemes.reads(name + 1, "-") && lexemes.reads(name + 2, "-");
      if (lexemes.is(name, Kind.NAME) && (twice || less)) {
        String word = lexemes.text(name);
        String text = " = " + word + " " + lexemes.text(name + 1) + " 1";
        fixes.add(
            QuickFix.replace(
                text("write", word + text),
                lexemes.get(name).end(),
                lexemes.get(name + 2).end(),
                text));
      }
    }
  }
}
