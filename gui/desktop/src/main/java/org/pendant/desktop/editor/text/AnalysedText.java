package org.pendant.desktop.editor.text;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedSet;
import org.pendant.kit.text.Messages;
import org.pendant.language.service.CharacterOffsets;
import org.pendant.language.service.Completion;
import org.pendant.language.service.FoldingRange;
import org.pendant.language.service.HighlightToken.Style;
import org.pendant.language.service.Hover;
import org.pendant.language.service.OutlineItem;
import org.pendant.language.service.Quantity;
import org.pendant.language.service.QuickFix;
import org.pendant.language.service.ScriptAnalysis;
import org.pendant.language.service.SignatureHelp;
import org.pendant.language.service.TextEdit;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;
import org.pendant.testing.builtin.ExpectationBuiltins;
import org.pendant.testing.builtin.TestCatalogue;

/**
 * Analysed text: one state of an editor's text and what is known about it, in characters. It never
 * changes; any thread may make and read it.
 */
public final class AnalysedText {
  /** What a file of tests says to have the names of other files, which are not read here. */
  private static final String IMPORT = ExpectationBuiltins.IMPORT + "(";

  private static final Set<String> OF_IMPORTS = Set.of("unknown-function", "unknown-variable");
  private final String text;
  private final CharacterOffsets offsets;
  private final ScriptAnalysis analysis;
  private final StyledLines colours;
  private final List<FoldingRange> folding;
  private final List<OutlineItem> outline;
  private final List<Problem> problems;
  private final Optional<SortedSet<Integer>> statementLines;

  private AnalysedText(String name, String text, Catalogue catalogue) {
    this.text = text;
    offsets = CharacterOffsets.of(text);
    analysis = ScriptAnalysis.of(Source.of(name, text), catalogue);
    // Asked for on the dispatch thread later, which need not wait for them.
    var _ = analysis.occurrences();
    colours = StyledLines.of(text, analysis.highlighting(), offsets);
    folding = analysis.folding();
    outline = analysis.outline();
    boolean imports = TestCatalogue.isFor(name) && text.contains(IMPORT);
    problems =
        analysis.diagnostics().stream()
            .filter(each -> !imports || !OF_IMPORTS.contains(each.code()))
            .map(this::problem)
            .toList();
    // A text that cannot be read has holes in its tree.
    boolean readable = problems.stream().noneMatch(Problem::isError);
    statementLines = readable ? Optional.of(analysis.breakpointLines()) : Optional.empty();
  }

  /** Reads and checks {@code text}, called {@code name} in messages. */
  public static AnalysedText of(String name, String text, Catalogue catalogue) {
    return new AnalysedText(name, text, catalogue);
  }

  /** The text that all offsets point into. */
  public String text() {
    return text;
  }

  /** What the language says about it, in bytes. */
  public ScriptAnalysis analysis() {
    return analysis;
  }

  /** What is wrong, in the order of the text. */
  public List<Problem> problems() {
    return problems;
  }

  /** Lines on which the program can stop; empty while errors keep the text from being read. */
  public Optional<SortedSet<Integer>> statementLines() {
    return statementLines;
  }

  /** Its colours, line by line. */
  List<StyledLine> lines() {
    return colours.lines();
  }

  /** How its own names are coloured. */
  Map<String, Style> names() {
    return colours.names();
  }

  /** What can be folded. */
  public List<FoldingRange> folding() {
    return folding;
  }

  /** Its definitions and globals. */
  public List<OutlineItem> outline() {
    return outline;
  }

  /** The characters of a range of bytes. */
  public TextSpan span(SourceRange range) {
    return new TextSpan(offsets.toCharacter(range.start()), offsets.toCharacter(range.end()));
  }

  /** The byte at which the character at {@code character} begins. */
  public int toByte(int character) {
    return offsets.toByte(character);
  }

  /** The character that holds a byte. */
  public int toCharacter(int offset) {
    return offsets.toCharacter(offset);
  }

  /** The line of a character, from 1. */
  public int line(int character) {
    return analysis.source().line(toByte(character));
  }

  /** Edits of bytes as edits of characters. */
  public List<Edit> edits(List<TextEdit> edits) {
    return edits.stream()
        .map(edit -> new Edit(span(edit.range()), ByteText.decoded(edit.text())))
        .toList();
  }

  /** The ways to put a problem right; each is tried, so ask on a worker thread. */
  public List<QuickFix> fixes(Problem problem) {
    return analysis.fixes(problem.diagnostic());
  }

  /** What may be typed at a character. */
  public List<Completion> completions(int character) {
    return analysis.completions(toByte(character));
  }

  /** The call around a character. */
  public Optional<SignatureHelp> signatureHelp(int character) {
    return analysis.signatureHelp(toByte(character));
  }

  /** What is known about the name at a character. */
  public Optional<Hover> hover(int character) {
    return analysis.hover(toByte(character));
  }

  /** The number at a character, if its place says in which unit it is. */
  public Optional<Quantity> quantity(int character) {
    return analysis.quantity(toByte(character));
  }

  /** Where the name at a character comes from. */
  public Optional<TextSpan> definition(int character) {
    return analysis.definition(toByte(character)).map(this::span);
  }

  /** Every place that means the same as the name at a character. */
  public List<TextSpan> references(int character) {
    return analysis.references(toByte(character)).stream()
        .map(occurrence -> span(occurrence.range()))
        .toList();
  }

  /** The problems that touch a character, or else those of its line. */
  public List<Problem> problemsAt(int character) {
    List<Problem> touched =
        problems.stream().filter(problem -> problem.span().touches(character)).toList();
    int line = line(character);
    return touched.isEmpty()
        ? problems.stream().filter(problem -> problem.line() == line).toList()
        : touched;
  }

  private Problem problem(Diagnostic diagnostic) {
    TextSpan span = span(diagnostic.range());
    int line = analysis.source().line(diagnostic.range().start());
    int column = span.start() - (text.lastIndexOf('\n', span.start() - 1) + 1) + 1;
    return new Problem(
        diagnostic, span, line, column, Messages.shown(ByteText.decoded(diagnostic.message())));
  }
}
