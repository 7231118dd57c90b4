package org.pendant.language.service;

import static org.pendant.language.service.ServiceTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SortedSet;
import org.pendant.language.check.CheckMemory;
import org.pendant.language.check.Checker;
import org.pendant.language.check.FunctionScope;
import org.pendant.language.check.ProgramForm;
import org.pendant.language.check.Scopes;
import org.pendant.language.check.ValueTypes;
import org.pendant.language.parse.ParseResult;
import org.pendant.language.parse.ReadText;
import org.pendant.language.parse.ScriptParser;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.signature.Signature;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Statement.Definition;

/**
 * One text, parsed and checked once, and what an editor may ask about it.
 *
 * <p>Offsets are byte offsets into {@link Source#text()}; {@link CharacterOffsets} converts those
 * of an editor that counts characters. Nothing here changes after {@link #of}: an analysis may be
 * made on a worker thread and read on any other. Texts with errors are answered as far as they can
 * be read.
 */
public final class ScriptAnalysis {
  private final Source source;
  private final Catalogue catalogue;
  private final ReadText read;
  private final ParseResult parsed;
  private final ProgramForm form;
  private final Scopes scopes;
  private final Lexemes lexemes;
  private final Signatures signatures;
  private final Optional<CheckMemory> memory;

  // Made when they are asked for: who types wants completions first.
  private final Deferred<List<Diagnostic>> diagnostics = new Deferred<>(this::check);
  private final Deferred<SymbolIndex> index = new Deferred<>(this::names);

  private ScriptAnalysis(
      Source source, Catalogue catalogue, ReadText read, Optional<CheckMemory> memory) {
    this.source = source;
    this.catalogue = catalogue;
    this.read = read;
    parsed = read.result();
    form = ProgramForm.of(parsed.script());
    scopes = Scopes.of(form);
    lexemes = Lexemes.of(source, read.lexemes());
    signatures = new Signatures(source, catalogue);
    this.memory = memory;
  }

  /** Reads and checks {@code source} against the functions of {@code catalogue}. */
  public static ScriptAnalysis of(Source source, Catalogue catalogue) {
    return new ScriptAnalysis(source, catalogue, ScriptParser.read(source), Optional.empty());
  }

  /**
   * The analysis of another text, most of which is in this one: what is the same is not read again.
   * It says the same as that of {@link #of}, only sooner.
   */
  public ScriptAnalysis changed(Source changed, Catalogue functions) {
    // Texts that are only opened need no memory.
    CheckMemory kept = memory.orElseGet(CheckMemory::new);
    return new ScriptAnalysis(
        changed, functions, ScriptParser.read(changed, read), Optional.of(kept));
  }

  /** The text that all offsets and ranges point into. */
  public Source source() {
    return source;
  }

  /** The functions that the text was checked against. */
  public Catalogue catalogue() {
    return catalogue;
  }

  /**
   * Syntax errors, and what the checker says: everything when there are none, else what is certain
   * whatever could not be read means. In the order of the text.
   */
  public List<Diagnostic> diagnostics() {
    return diagnostics.get();
  }

  private List<Diagnostic> check() {
    if (parsed.ok() && memory.isPresent()) {
      return Checker.check(source, form, scopes, catalogue, memory.get());
    }
    List<Diagnostic> found = Checker.check(form, scopes, catalogue);
    return parsed.ok() ? found : PartialCheck.of(lexemes, parsed.diagnostics(), found);
  }

  private SymbolIndex names() {
    return SymbolIndex.of(parsed.script(), scopes, catalogue);
  }

  /**
   * The ways to put {@code diagnostic}, one of this text, right that are clear. Each has been
   * tried: after it this diagnostic is gone and there are no more syntax errors than before.
   */
  public List<QuickFix> fixes(Diagnostic diagnostic) {
    return new QuickFixes(this, diagnostic).working();
  }

  /** What may be typed at {@code offset}, the likeliest first. */
  public List<Completion> completions(int offset) {
    return Completer.complete(this, within(offset));
  }

  /** The innermost call around {@code offset} that is known, if there is one. */
  public Optional<SignatureHelp> signatureHelp(int offset) {
    Optional<CallPlace> place = CallPlace.around(lexemes, within(offset));
    while (place.isPresent()) {
      CallPlace call = place.get();
      Optional<Signature> called = callee(call);
      if (called.isPresent()) {
        return Optional.of(SignatureHelp.of(lexemes, call, called.get()));
      }
      place = call.outer(lexemes);
    }
    return Optional.empty();
  }

  /** What is known about the name at {@code offset}. */
  public Optional<Hover> hover(int offset) {
    return occurrence(offset).map(new HoverTexts(this)::of);
  }

  /** The number at {@code offset}, if its place says in which unit it is. */
  public Optional<Quantity> quantity(int offset) {
    return new Quantities(this).at(within(offset));
  }

  /** Functions, threads and globals, nested as in the text. */
  public List<OutlineItem> outline() {
    return Outline.of(this);
  }

  /** Blocks and comments that can be folded, by their first line. */
  public List<FoldingRange> folding() {
    return Folding.of(lexemes);
  }

  /** The name at {@code offset} and what it stands for. */
  public Optional<Occurrence> occurrence(int offset) {
    return index().at(within(offset));
  }

  /** Where the name at {@code offset} is defined or first assigned; nowhere for built-ins. */
  public Optional<SourceRange> definition(int offset) {
    return occurrence(offset)
        .flatMap(found -> index().origin(found.symbol()))
        .map(Occurrence::range);
  }

  /** Every place that means the same as the name at {@code offset}, itself included. */
  public List<Occurrence> references(int offset) {
    return occurrence(offset).map(found -> index().of(found.symbol())).orElse(List.of());
  }

  /** The edits that give the name at {@code offset} the name {@code newName} everywhere. */
  public RenameResult rename(int offset, String newName) {
    return new Renaming(this, newName).at(within(offset));
  }

  /** The text in colours; {@link Highlighting#of} does it without an analysis. */
  public List<HighlightToken> highlighting() {
    return Highlighting.of(lexemes, catalogue);
  }

  /** The edits that lay the text out evenly, or why it is left alone. */
  public FormatResult format(FormatOptions options) {
    Optional<Diagnostic> error = syntaxError();
    if (error.isPresent()) {
      int line = source.line(error.get().range().start());
      return new FormatResult.Refused(text("formatRefused", line, error.get().message()));
    }
    return new FormatResult.Formatted(Formatter.edits(lexemes, options));
  }

  /** The 1-based lines on which a statement or a condition begins that runs. */
  public SortedSet<Integer> breakpointLines() {
    return StatementLines.of(parsed.script()).lines();
  }

  /** The smallest statement that covers a part of {@code line} (1-based). */
  public Optional<SourceRange> enclosingStatement(int line) {
    return StatementLines.of(parsed.script()).enclosing(line);
  }

  /** Every place where a name stands, in the order of the text. */
  public List<Occurrence> occurrences() {
    return index().all();
  }

  /** The functions, secondary programs and threads of the text, also those inside others. */
  public List<DefinedFunction> definitions() {
    return scopes.definitions().stream()
        .filter(each -> !each.name().isEmpty())
        .map(each -> new DefinedFunction(signatures.of(each), each.nameRange()))
        .toList();
  }

  /** The names of the global variables. */
  public Set<String> globals() {
    return scopes.globals();
  }

  /** Every call of a function or method and every start of a thread, in the order of the text. */
  public List<CallSite> calls() {
    return CallSites.of(this, parsed.script());
  }

  /** The poses that are written as six numbers, in the order of the text. */
  public List<WrittenPose> poses() {
    return WrittenPoses.of(parsed.script());
  }

  /**
   * The words of the block whose word is at {@code offset}: {@code if}, {@code elif}, {@code else}
   * and {@code end}, or {@code def} and {@code end}; none at any other place.
   */
  public List<SourceRange> blockWords(int offset) {
    return BlockWords.at(lexemes, within(offset));
  }

  /** What stands around {@code offset}, from the word there to the whole text, each in the next. */
  public List<SourceRange> enclosing(int offset) {
    int word = lexemes.at(within(offset));
    List<SourceRange> inner = word < 0 ? List.of() : List.of(lexemes.get(word).range());
    return Enclosing.of(parsed.script(), offset, inner);
  }

  Lexemes lexemes() {
    return lexemes;
  }

  SymbolIndex index() {
    return index.get();
  }

  Scopes scopes() {
    return scopes;
  }

  Signatures signatures() {
    return signatures;
  }

  ValueTypes types() {
    return ValueTypes.of(form, scopes, catalogue);
  }

  Optional<Diagnostic> syntaxError() {
    return parsed.diagnostics().stream().filter(Diagnostic::isError).findFirst();
  }

  long syntaxErrors() {
    return parsed.diagnostics().stream().filter(Diagnostic::isError).count();
  }

  /** The scope whose variables a name at {@code offset} may mean. */
  FunctionScope scopeAt(int offset) {
    FunctionScope found = scopes.mainScope();
    int innermost = -1;
    for (Definition definition : scopes.definitions()) {
      int start = definition.range().start();
      if (start > innermost && start < offset && reaches(definition.range(), offset)) {
        innermost = start;
        found = scopes.scope(definition);
      }
    }
    return found;
  }

  /** A block whose {@code end} is still missing continues where its range ends. */
  private boolean reaches(SourceRange range, int offset) {
    boolean closed = source.text().startsWith("end", Math.max(0, range.end() - 3));
    return offset < range.end() || (!closed && offset == range.end());
  }

  /**
   * The definition whose name stands at {@code nameOffset}.
   *
   * @throws IllegalArgumentException if there is none
   */
  Definition definitionAt(int nameOffset) {
    return scopes.definitions().stream()
        .filter(definition -> definition.nameRange().start() == nameOffset)
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException("no definition at " + nameOffset));
  }

  /** What is called at {@code place}, if it is a call of something known. */
  Optional<Signature> callee(CallPlace place) {
    if (!place.isCall(lexemes)) {
      return Optional.empty();
    }
    int at = place.opener() - 1;
    String name = lexemes.text(at);
    FunctionScope scope = scopeAt(lexemes.get(at).start());
    if (!place.isMethod(lexemes)) {
      return signatures.function(name, scope);
    }
    Receiver receiver = Receiver.of(this, lexemes.previous(at - 1), scope);
    return signatures.methods(receiver.type()).stream()
        .filter(method -> method.name().equals(name))
        .findFirst();
  }

  /** What the variable {@code name} stands for at {@code offset}. */
  Symbol variable(String name, int offset) {
    FunctionScope scope = scopeAt(offset);
    return new SymbolWalk(scopes, catalogue).variable(scope.resolve(name, offset), scope);
  }

  /** The blanks at the start of the line of {@code offset}. */
  String indentationAt(int offset) {
    String line = source.lineText(source.line(offset));
    return line.substring(0, line.length() - line.stripLeading().length());
  }

  /** How lines end in this text. */
  String lineEnd() {
    return source.text().contains("\r\n") ? "\r\n" : "\n";
  }

  private int within(int offset) {
    if (offset < 0 || offset > source.text().length()) {
      throw new IllegalArgumentException(
          "offset " + offset + " is outside the text, expected 0 to " + source.text().length());
    }
    return offset;
  }
}
