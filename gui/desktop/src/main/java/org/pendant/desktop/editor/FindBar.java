package org.pendant.desktop.editor;

import static org.pendant.desktop.editor.EditorTexts.text;

import java.awt.Component;
import java.awt.event.KeyEvent;
import java.util.Comparator;
import java.util.List;
import java.util.function.Supplier;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import javax.swing.KeyStroke;
import javax.swing.SortingFocusTraversalPolicy;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import net.miginfocom.swing.MigLayout;
import org.fife.ui.rtextarea.DocumentRange;
import org.pendant.desktop.editor.text.Edit;
import org.pendant.desktop.editor.text.FindState;
import org.pendant.desktop.editor.text.SearchQuery;
import org.pendant.desktop.editor.text.TextSpan;
import org.pendant.kit.theme.Palette;

/** Find bar: finds and replaces in the program in front. */
@SuppressWarnings("serial") // never written to a stream
final class FindBar extends JPanel {
  private static final int MAX_MARKED = 2_000;

  private final Supplier<ProgramEditor> editor;
  private final JTextField words = field("find-words", text("find"));
  private final JTextField replacement = field("find-replacement", text("replaceBy"));
  private final JToggleButton matchCase = toggle("Aa", "match-case", text("matchCase"));
  private final JToggleButton wholeWord = toggle("W", "whole-words-only", text("wholeWordsOnly"));
  private final JToggleButton regex = toggle(".*", "regular-expression", text("regularExpression"));
  private final JLabel summary = new JLabel(" ");
  private final JLabel replaceLabel = new JLabel(text("replaceBy"));
  private final JButton replace =
      button(text("replace"), "replace-this-match", text("replaceThisMatch"), this::replace);
  private final JButton replaceAll =
      button(
          text("replaceAll"), "replace-every-match", text("replaceEveryMatch"), this::replaceAll);
  private FindState state = FindState.NONE;

  FindBar(Supplier<ProgramEditor> editor) {
    super(
        new MigLayout(
            "insets 6 12 6 12, gap 6, fillx, hidemode 3",
            "[][grow,120:360:360][][][][]12[]push[]"));
    this.editor = editor;
    setName("find-bar");
    setBorder(BorderFactory.createMatteBorder(1, 0, 0, 0, Palette.line()));
    JLabel label = new JLabel(text("find"));
    label.setLabelFor(words);
    replaceLabel.setLabelFor(replacement);
    summary.setName("find-summary");
    JButton previous =
        button("\u2191", "previous-match", text("previousMatchKeys"), () -> step(false));
    JButton next = button("\u2193", "next-match", text("nextMatchKeys"), () -> step(true));
    JButton close = button("\u2715", "close", text("closeKeys"), this::close);
    add(label);
    add(words, "growx");
    add(matchCase, "split 3, gapright 0");
    add(wholeWord, "gapright 0");
    add(regex);
    add(previous);
    add(next);
    add(summary, "wmin 96, growx");
    add(close, "skip, wrap");
    add(replaceLabel);
    add(replacement, "growx");
    add(replace, "span, split 2");
    add(replaceAll);
    words.getDocument().addDocumentListener(new Typed());
    List.of(matchCase, wholeWord, regex)
        .forEach(each -> each.addActionListener(event -> search(true)));
    // These fields would take the window's key for deleting backwards.
    key(words, "control H", () -> open(true));
    key(replacement, "control H", () -> open(true));
    key(words, "ENTER", () -> step(true));
    key(words, "shift ENTER", () -> step(false));
    key(replacement, "ENTER", this::replace);
    key(replacement, "alt ENTER", this::replaceAll);
    registerKeyboardAction(
        event -> close(),
        KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0),
        WHEN_ANCESTOR_OF_FOCUSED_COMPONENT);
    // From what is looked for, Tab goes to what is to stand there.
    setFocusTraversalPolicyProvider(true);
    setFocusTraversalPolicy(
        new SortingFocusTraversalPolicy(
            Comparator.comparingInt(
                List.<Component>of(
                        words,
                        replacement,
                        replace,
                        replaceAll,
                        matchCase,
                        wholeWord,
                        regex,
                        previous,
                        next,
                        close)
                    ::indexOf)));
    setVisible(false);
  }

  /** Opens it with the selected words, for finding alone or for replacing too. */
  void open(boolean replacing) {
    String selected = editor.get().area().getSelectedText();
    setVisible(true);
    List.of(replaceLabel, replacement, replace, replaceAll)
        .forEach(each -> each.setVisible(replacing));
    if (selected != null && !selected.contains("\n")) {
      words.setText(selected);
    }
    words.selectAll();
    words.requestFocusInWindow();
    search(false);
    revalidate();
  }

  void close() {
    setVisible(false);
    editor.get().area().clearMarkAllHighlights();
    editor.get().area().requestFocusInWindow();
  }

  /** The text or the program in front is another. */
  void refresh() {
    if (isVisible()) {
      search(false);
    }
  }

  /** Selects the next or the previous match. */
  void step(boolean forward) {
    ScriptArea area = editor.get().area();
    search(false);
    int index =
        forward ? state.from(area.getSelectionEnd()) : state.before(area.getSelectionStart());
    select(index);
  }

  private SearchQuery query() {
    return new SearchQuery(
        words.getText(), matchCase.isSelected(), wholeWord.isSelected(), regex.isSelected());
  }

  /**
   * Looks again.
   *
   * @param jump whether to select the first match at or behind the caret
   */
  private void search(boolean jump) {
    ScriptArea area = editor.get().area();
    state = FindState.of(query(), area.getText());
    area.clearMarkAllHighlights();
    if (!state.matches().isEmpty()) {
      area.markAll(
          near(area.getCaretPosition()).stream()
              .map(each -> new DocumentRange(each.start(), each.end()))
              .toList());
    }
    if (jump) {
      select(state.from(area.getSelectionStart()));
    }
    showSummary();
  }

  /** The matches around the caret, as many as can be painted without delay. */
  private List<TextSpan> near(int caret) {
    List<TextSpan> all = state.matches();
    int from = Math.clamp(state.from(caret) - MAX_MARKED / 2, 0, all.size());
    return all.subList(from, Math.min(all.size(), from + MAX_MARKED));
  }

  private void select(int index) {
    if (index >= 0) {
      editor.get().area().show(state.matches().get(index));
    }
    showSummary();
  }

  private void showSummary() {
    ScriptArea area = editor.get().area();
    String text = state.summary(new TextSpan(area.getSelectionStart(), area.getSelectionEnd()));
    boolean nothing = !words.getText().isEmpty() && state.matches().isEmpty();
    summary.setText(text.isEmpty() ? " " : text);
    summary.setForeground(nothing ? Palette.error() : Palette.quiet());
    words.putClientProperty("JComponent.outline", nothing ? "error" : null);
    words.setToolTipText(nothing ? text : text("whatToFindEnterGoesTo"));
    replace.setEnabled(!nothing);
    replaceAll.setEnabled(!nothing);
  }

  private void replace() {
    ScriptArea area = editor.get().area();
    TextSpan selected = new TextSpan(area.getSelectionStart(), area.getSelectionEnd());
    search(false);
    if (state.matches().contains(selected)) {
      replaced(
          () -> {
            Edit edit = state.query().replacement(area.getText(), selected, replacement.getText());
            area.make(List.of(edit));
            area.setCaretPosition(selected.start() + edit.text().length());
          });
    }
    step(true);
  }

  private void replaceAll() {
    search(false);
    ScriptArea area = editor.get().area();
    int count = state.matches().size();
    replaced(
        () -> {
          List<Edit> edits = state.replaceAll(area.getText(), replacement.getText());
          editor.get().gather(() -> area.make(edits));
          search(false);
          summary.setForeground(Palette.quiet());
          summary.setText(count == 1 ? text("replacedOne") : text("replacedSeveral", count));
        });
  }

  /** Does it, or says at the field why it cannot be done. */
  private void replaced(Runnable work) {
    if (!editor.get().area().isEditable()) {
      replacement.setToolTipText(text("theScriptIsGeneratedTheProgram"));
      return;
    }
    try {
      work.run();
      replacement.putClientProperty("JComponent.outline", null);
      replacement.setToolTipText(text("whatComesInPlaceOfA"));
    } catch (IllegalArgumentException e) {
      replacement.putClientProperty("JComponent.outline", "error");
      replacement.setToolTipText(e.getMessage());
      summary.setForeground(Palette.error());
      summary.setText(e.getMessage());
    }
  }

  private static JTextField field(String name, String accessible) {
    JTextField field = new JTextField();
    field.setName(name);
    field.getAccessibleContext().setAccessibleName(accessible);
    field.setToolTipText(accessible);
    return field;
  }

  private static JToggleButton toggle(String text, String name, String tip) {
    JToggleButton toggle = new JToggleButton(text);
    toggle.setName("find-" + name);
    toggle.setToolTipText(tip);
    toggle.getAccessibleContext().setAccessibleName(tip);
    toggle.putClientProperty("JButton.buttonType", "toolBarButton");
    return toggle;
  }

  private static JButton button(String text, String name, String tip, Runnable run) {
    JButton button = new JButton(text);
    button.setToolTipText(tip);
    button.getAccessibleContext().setAccessibleName(tip);
    button.setName("find-" + name);
    button.addActionListener(event -> run.run());
    return button;
  }

  private static void key(JTextField field, String keys, Runnable run) {
    field.registerKeyboardAction(
        event -> run.run(), KeyStroke.getKeyStroke(keys), JComponent.WHEN_FOCUSED);
  }

  /** Searches while words are typed. */
  private final class Typed implements DocumentListener {
    @Override
    public void insertUpdate(DocumentEvent event) {
      search(true);
    }

    @Override
    public void removeUpdate(DocumentEvent event) {
      search(true);
    }

    @Override
    public void changedUpdate(DocumentEvent event) {}
  }
}
