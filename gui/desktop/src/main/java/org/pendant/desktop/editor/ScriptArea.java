package org.pendant.desktop.editor;

import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.KeyboardFocusManager;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.IntConsumer;
import java.util.function.Predicate;
import java.util.function.Supplier;
import javax.swing.JToolTip;
import javax.swing.KeyStroke;
import javax.swing.text.BadLocationException;
import javax.swing.text.Element;
import org.fife.ui.rsyntaxtextarea.RSyntaxDocument;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.fife.ui.rsyntaxtextarea.folding.FoldManager;
import org.fife.ui.rsyntaxtextarea.folding.FoldParserManager;
import org.pendant.desktop.editor.text.AnalysedText;
import org.pendant.desktop.editor.text.AutoIndent;
import org.pendant.desktop.editor.text.Edit;
import org.pendant.desktop.editor.text.LineColours;
import org.pendant.desktop.editor.text.LineIndex;
import org.pendant.desktop.editor.text.TextSpan;

/**
 * Script area: the text component, set up for scripts. Offsets count characters, lines count from
 * 1.
 */
@SuppressWarnings("serial") // never written to a stream
final class ScriptArea extends RSyntaxTextArea {
  private static final String STYLE = "text/urscript";

  /** The component's own timer has nothing to do: results are handed over when they come. */
  private static final int NEVER_MS = 1 << 30;

  private static final int MIN_ZOOM = -5;
  private static final int MAX_ZOOM = 24;

  private final Supplier<Optional<AnalysedText>> analysed;
  private final Predicate<KeyStroke> takenKeys;
  private Function<Integer, Optional<String>> tips = offset -> Optional.empty();
  private IntConsumer typed = c -> {};
  private ExecutionBand band;
  private final LineNotes notes = new LineNotes(this);
  private ScriptTyping typing;
  private final TabStops tabStops;
  private final TextTip tip = new TextTip(this);
  private int zoom;

  /**
   * An empty text.
   *
   * @param colours asked for the colours of lines
   * @param analysed what is known about the text as it is
   * @param takenKeys which keys belong to the window around it
   */
  ScriptArea(
      LineColours colours,
      Supplier<Optional<AnalysedText>> analysed,
      Predicate<KeyStroke> takenKeys) {
    super(new RSyntaxDocument(SYNTAX_STYLE_NONE));
    this.analysed = analysed;
    this.takenKeys = takenKeys;
    // The component asks for the fold parser when its style changes: it must be known before.
    FoldParserManager.get().addFoldParserMapping(STYLE, new ScriptFolds());
    setSyntaxEditingStyle(STYLE);
    RSyntaxDocument document = (RSyntaxDocument) getDocument();
    document.setSyntaxStyle(new ScriptTokenMaker(document, colours));
    setCodeFoldingEnabled(true);
    setTabSize(AutoIndent.STEP);
    setTabsEmulated(true);
    setBracketMatchingEnabled(true);
    setPaintMatchedBracketPair(true);
    setAnimateBracketMatching(false);
    setShowMatchedBracketPopup(false);
    setAutoIndentEnabled(false);
    setCloseCurlyBraces(false);
    setInsertPairedCharacters(false);
    setClearWhitespaceLinesEnabled(false);
    setHyperlinksEnabled(false);
    setUseFocusableTips(false);
    setMarkOccurrences(false);
    setParserDelay(NEVER_MS);
    setPopupMenu(null);
    setTransferHandler(new ScriptTransfer());
    setName("script-text");
    getAccessibleContext().setAccessibleName(EditorTexts.text("script"));
    typing = new ScriptTyping(this);
    // The window has these keys for its tabs; alt and a number leaves the text.
    setFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, Set.of());
    setFocusTraversalKeys(KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS, Set.of());
    setToolTipText("");
    band = new ExecutionBand(this);
    tabStops = new TabStops(this);
  }

  /** The arguments of completed calls that TAB goes to. */
  TabStops tabStops() {
    return tabStops;
  }

  /** Marks where the program is, and puts its note there. */
  void setExecution(Execution execution) {
    band.set(execution);
  }

  /** Takes over the colours of the present theme. */
  void themeChanged() {
    band.refresh();
  }

  @Override
  protected void paintComponent(Graphics g) {
    super.paintComponent(g);
    band.paintNote(g);
    Graphics2D pen = pen(g);
    notes.paint(pen, band.noted());
    pen.dispose();
  }

  /** A pen that writes as the screen does, for the caller to dispose. */
  Graphics2D pen(Graphics g) {
    Graphics2D pen = (Graphics2D) g.create();
    Object hints = getToolkit().getDesktopProperty("awt.font.desktophints");
    if (hints instanceof Map<?, ?> map) {
      pen.addRenderingHints(map);
    } else {
      pen.setRenderingHint(
          RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    }
    return pen;
  }

  /** What stands behind lines. */
  LineNotes notes() {
    return notes;
  }

  /** What is known about the text as it is. */
  Optional<AnalysedText> analysed() {
    return analysed.get();
  }

  /** Asks {@code tips} what to say about the character under the pointer, as HTML. */
  void setTips(Function<Integer, Optional<String>> tips) {
    this.tips = tips;
  }

  /** Tells {@code typed} of every single character that is typed, after it is in the text. */
  void setTyped(IntConsumer typed) {
    this.typed = typed;
  }

  /** Points that the font is larger than usual. */
  int zoom() {
    return zoom;
  }

  void setZoom(int wanted) {
    zoom = Math.clamp(wanted, MIN_ZOOM, MAX_ZOOM);
  }

  /** Takes the marks of a search away, also along the text, which the component forgets. */
  @Override
  public void clearMarkAllHighlights() {
    super.clearMarkAllHighlights();
    firePropertyChange(MARK_ALL_OCCURRENCES_CHANGED_PROPERTY, 0, 1);
  }

  /** Makes all of {@code edits} as one step of undo; the caret stays at its text. */
  void make(List<Edit> edits) {
    int caret = Edit.moved(getCaretPosition(), edits);
    beginAtomicEdit();
    for (Edit edit : Edit.backwards(edits)) {
      replaceRange(edit.text(), edit.span().start(), edit.span().end());
    }
    endAtomicEdit();
    setCaretPosition(caret);
  }

  /** Where the characters of {@code offset} are painted. */
  Rectangle place(int offset) {
    try {
      Rectangle2D place = modelToView2D(Math.clamp(offset, 0, getDocument().getLength()));
      return place == null ? new Rectangle() : place.getBounds();
    } catch (BadLocationException e) {
      throw new IllegalStateException("offset " + offset + " is clamped to the text", e);
    }
  }

  /** Selects {@code span} and scrolls it to the middle if it is not in sight; opens folds. */
  void show(TextSpan span) {
    int end = Math.clamp(span.end(), 0, getDocument().getLength());
    int start = Math.clamp(span.start(), 0, end);
    getFoldManager().ensureOffsetNotInClosedFold(start);
    setCaretPosition(start);
    moveCaretPosition(end);
    Rectangle place = place(start);
    Rectangle seen = getVisibleRect();
    boolean inSight = seen.y <= place.y && place.y + 2 * place.height <= seen.y + seen.height;
    if (!inSight) {
      int y = Math.max(0, place.y - seen.height / 3);
      scrollRectToVisible(new Rectangle(0, y, 1, seen.height));
    }
  }

  /** The characters of line {@code line}, without its end; of the nearest if there is none. */
  TextSpan line(int line) {
    Element root = getDocument().getDefaultRootElement();
    Element element = root.getElement(Math.clamp(line - 1, 0, root.getElementCount() - 1));
    return new TextSpan(element.getStartOffset(), element.getEndOffset() - 1);
  }

  /** Has lines painted again; those that a fold hides have no place, all is painted for them. */
  void repaintLines(int first, int last) {
    FoldManager folds = getFoldManager();
    if (folds.isLineHidden(first - 1) || folds.isLineHidden(last - 1)) {
      repaint();
      return;
    }
    Rectangle lines = place(line(first).start()).union(place(line(last).start()));
    repaint(0, lines.y, getWidth(), lines.height);
  }

  /** The line of {@code offset}. */
  int lineAt(int offset) {
    return getDocument().getDefaultRootElement().getElementIndex(offset) + 1;
  }

  /** Puts a line below the one of the caret, indented as that is, as one step of undo. */
  void insertLine(String text) {
    TextSpan line = line(lineAt(getCaretPosition()));
    String before = getText().substring(line.start(), line.end());
    String indent = before.substring(0, before.length() - before.stripLeading().length());
    insert("\n" + indent + text, line.end());
    setCaretPosition(line.end() + 1 + indent.length() + text.length());
  }

  /** The lines that the selection touches, or the line of the caret. */
  List<TextSpan> selectedLines() {
    return LineIndex.touched(getText(), new TextSpan(getSelectionStart(), getSelectionEnd()));
  }

  @Override
  public JToolTip createToolTip() {
    return tip.shown(super.createToolTip());
  }

  @Override
  public String getToolTipText(MouseEvent event) {
    Optional<String> note = band.tip(event.getPoint()).or(() -> notes.tip(event.getPoint()));
    if (note.isPresent()) {
      return note.get();
    }
    int offset = viewToModel2D(event.getPoint());
    if (offset < 0 || !isOver(offset, event.getPoint())) {
      return null;
    }
    return tips.apply(offset).orElse(null);
  }

  private boolean isOver(int offset, Point point) {
    Rectangle place = place(offset);
    return point.y >= place.y
        && point.y < place.y + place.height
        && Math.abs(point.x - place.x) < 2 * place.height;
  }

  /** Plain keys write; any other may belong to the window, which gets it if we let it go. */
  @Override
  protected boolean processKeyBinding(
      KeyStroke key, KeyEvent event, int condition, boolean pressed) {
    if (event.getID() == KeyEvent.KEY_TYPED && event.isControlDown() && !event.isAltDown()) {
      return true; // what a key with CTRL does is done when it is pressed; it writes nothing
    }
    boolean plain = event.getModifiersEx() == 0 && !event.isActionKey();
    if (pressed && !plain && takenKeys != null && takenKeys.test(key)) {
      return false;
    }
    return super.processKeyBinding(key, event, condition, pressed);
  }

  @Override
  public void replaceSelection(String text) {
    if (text == null || text.length() != 1 || typing == null) {
      super.replaceSelection(text);
      return;
    }
    typing.write(text.charAt(0));
    typed.accept(text.charAt(0));
  }

  /** Tells of a key that wrote, or of a new line. */
  void tellTyped(char c) {
    typed.accept(c);
  }

  /** Puts text in place of the selection just as it is. */
  void insertPlain(String text) {
    super.replaceSelection(text);
  }

  String text(TextSpan span) {
    try {
      return getText(span.start(), span.end() - span.start());
    } catch (BadLocationException e) {
      throw new IllegalArgumentException(span + " is not in the text", e);
    }
  }
}
