package org.pendant.desktop.shell.prompt;

import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.awt.event.ActionEvent;
import java.util.List;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.message.Popup.Severity;
import org.pendant.kit.icon.Glyph;
import org.pendant.kit.icon.SvgIcon;
import org.pendant.kit.layout.Typed;
import org.pendant.kit.theme.Palette;

/** Prompt form: the widgets that show one popup or question. */
final class PromptForm {
  private static final int MIN_ROWS = 2;
  private static final int MAX_ROWS = 14;

  /** In a window that is too low the hint goes first, then the text; buttons stay. */
  private static final String ROWS =
      "[pref!][grow, shrinkprio 200, 24::][pref!][shrinkprio 100, 0::pref]"
          + "[shrinkprio 300, 0::pref][pref!]";

  private static final String BUTTON = "h 32::, wmin 80";

  private final JPanel panel =
      new JPanel(new MigLayout("insets 0, gap 0, wrap 1, hidemode 3", "[grow, fill, 0::]", ROWS));
  private final JLabel title = new JLabel();
  private final JLabel place = new JLabel();
  private final JButton next = button("popup-next", PromptTexts.text("next"));
  private final JTextArea text = new JTextArea(MIN_ROWS, 44);
  private final JTextField field = new JTextField();
  private final JTextArea error = words("popup-error");
  private final JLabel hint = new JLabel();
  private final JButton stop = button("popup-stop", PromptTexts.text("stopProgram"));
  private final JButton no = button("popup-no", PromptTexts.text("no"));
  private final JButton yes = button("popup-yes", PromptTexts.text("yes"));
  private final JButton go = button("popup-continue", PromptTexts.text("continue"));
  private final List<JButton> buttons = List.of(next, stop, no, yes, go);
  private JComponent safeChoice = go;

  PromptForm(PromptPanel.Gestures gestures) {
    panel.setOpaque(false);
    title.putClientProperty("FlatLaf.styleClass", "h3");
    title.setName("popup-title");
    place.setName("popup-place");
    hint.setName("popup-hint");
    text.setName("popup-text");
    text.setEditable(false);
    text.setLineWrap(true);
    text.setWrapStyleWord(true);
    text.setToolTipText(PromptTexts.text("whatTheProgramSays"));
    text.getAccessibleContext().setAccessibleName(PromptTexts.text("whatTheProgramSays"));
    // Tab leaves it, as there is nothing to type.
    text.setFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, null);
    text.setFocusTraversalKeys(KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS, null);
    field.setName("popup-field");
    field.getAccessibleContext().setAccessibleName(PromptTexts.text("answer"));
    field.setToolTipText(PromptTexts.text("enterGivesTheAnswer"));
    field.addActionListener(event -> gestures.enter(field.getText()));
    field
        .getDocument()
        .addDocumentListener(
            new Typed(
                () -> {
                  if (error.isVisible()) {
                    showError("");
                  }
                }));
    next.addActionListener(event -> gestures.next());
    tip(next, PromptTexts.text("showsTheNextOneThisOne"));
    stop.addActionListener(event -> gestures.stop());
    no.addActionListener(event -> gestures.answer(false));
    tip(no, PromptTexts.text("answersNoN"));
    yes.addActionListener(event -> gestures.answer(true));
    tip(yes, PromptTexts.text("answersYesY"));
    go.addActionListener(
        event -> {
          if (field.isVisible()) {
            gestures.enter(field.getText());
          } else {
            gestures.close();
          }
        });
    key('y', yes);
    key('Y', yes);
    key('n', no);
    key('N', no);
    JPanel top = row("[grow, 0::][][]");
    // A long title ends in an ellipsis; the text decides how wide this is.
    top.add(title, "growx, w 0:100:");
    top.add(place);
    top.add(next);
    // Buttons that are not there leave no gaps.
    JPanel answers = new JPanel(new MigLayout("insets 0, gap 8, hidemode 3, nogrid"));
    answers.setOpaque(false);
    List.of(no, yes, go).forEach(each -> answers.add(each, BUTTON));
    JPanel bottom = row("[][grow, right]");
    bottom.add(stop, "cell 0 0, " + BUTTON);
    bottom.add(answers, "cell 1 0");
    panel.add(top);
    panel.add(new JScrollPane(text), "grow, hmin 0, gaptop 8");
    panel.add(field, "gaptop 8");
    panel.add(error, "gaptop 8, hmin 0");
    panel.add(hint, "gaptop 8, hmin 0");
    panel.add(bottom, "gaptop 8");
  }

  private static JPanel row(String columns) {
    JPanel row = new JPanel(new MigLayout("insets 0, gap 8, hidemode 3", columns));
    row.setOpaque(false);
    return row;
  }

  private static JButton button(String name, String words) {
    JButton button = new JButton(words);
    button.setName(name);
    Action press =
        new AbstractAction() {
          @Override
          public void actionPerformed(ActionEvent event) {
            button.doClick();
          }
        };
    button.getInputMap().put(KeyStroke.getKeyStroke("ENTER"), "press");
    button.getActionMap().put("press", press);
    return button;
  }

  /** Words that wrap. */
  private static JTextArea words(String name) {
    JTextArea area = new JTextArea();
    area.setName(name);
    area.setEditable(false);
    area.setFocusable(false);
    area.setLineWrap(true);
    area.setWrapStyleWord(true);
    area.setOpaque(false);
    area.setBorder(BorderFactory.createEmptyBorder());
    return area;
  }

  private static void tip(JButton button, String tip) {
    button.setToolTipText(tip);
    button.getAccessibleContext().setAccessibleName(button.getText());
    button.getAccessibleContext().setAccessibleDescription(tip);
  }

  /** A letter that presses a button wherever the focus is in here; typing is not disturbed. */
  private void key(char letter, JButton button) {
    panel
        .getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
        .put(KeyStroke.getKeyStroke(letter), letter);
    panel
        .getActionMap()
        .put(
            letter,
            new AbstractAction() {
              @Override
              public void actionPerformed(ActionEvent event) {
                if (button.isVisible()) {
                  button.doClick();
                }
              }
            });
  }

  JPanel component() {
    return panel;
  }

  /** Shows a popup or question; nothing is typed yet. */
  void show(Prompt prompt) {
    boolean question = prompt.kind().isPresent();
    panel.getAccessibleContext().setAccessibleName(prompt.title());
    title.setText(prompt.title());
    title.setToolTipText(prompt.title());
    title.setIcon(question ? icon(Glyph.QUESTION) : icon(prompt.severity()));
    text.setText(prompt.text());
    text.setCaretPosition(0);
    field.setText("");
    field.setVisible(prompt.typed());
    field.getAccessibleContext().setAccessibleName(prompt.text());
    showError("");
    stop.setText(
        question ? PromptTexts.text("cancelAndStopProgram") : PromptTexts.text("stopProgram"));
    tip(
        stop,
        question
            ? PromptTexts.text("endsTheProgramWithoutAnAnswer")
            : PromptTexts.text("endsTheProgramWhichWaits"));
    stop.setVisible(prompt.waits());
    no.setVisible(prompt.yesOrNo());
    yes.setVisible(prompt.yesOrNo());
    go.setText(
        question
            ? PromptTexts.text("ok")
            : prompt.waits() ? PromptTexts.text("continue") : PromptTexts.text("close"));
    tip(
        go,
        question
            ? PromptTexts.text("givesTheAnswer")
            : prompt.waits()
                ? PromptTexts.text("theProgramContinues")
                : PromptTexts.text("closesIt"));
    go.setVisible(!prompt.yesOrNo());
    safeChoice = prompt.yesOrNo() ? no : prompt.typed() ? field : go;
  }

  /** Gives the text as many rows as it needs, within reason. */
  void fit() {
    int width = text.getPreferredScrollableViewportSize().width;
    text.setSize(width, Short.MAX_VALUE);
    int row = text.getFontMetrics(text.getFont()).getHeight();
    text.setRows(MIN_ROWS);
    int border = text.getInsets().top + text.getInsets().bottom;
    int lines = Math.ceilDiv(text.getUI().getPreferredSize(text).height - border, row);
    text.setRows(Math.clamp(lines, MIN_ROWS, MAX_ROWS));
  }

  /** Says why what was typed is no answer; empty for nothing. */
  void showError(String why) {
    error.setText(why);
    error.setVisible(!why.isEmpty());
    field.putClientProperty("JComponent.outline", why.isEmpty() ? null : "error");
    field.getAccessibleContext().setAccessibleDescription(why);
    panel.revalidate();
  }

  /** Shows which one of several this is; empty for the only one. */
  void showPlace(String words) {
    place.setForeground(Palette.quiet());
    place.setText(words);
    next.setVisible(!words.isEmpty());
  }

  /** Says what the keys do here; called again and again. */
  void showHint(String words) {
    hint.setForeground(Palette.quiet());
    // The theme may change while an error is shown.
    error.setForeground(Palette.error());
    if (!words.equals(hint.getText())) {
      hint.setText(words);
      hint.setToolTipText(words);
    }
  }

  /** Whether the buttons can be pressed. */
  void setReady(boolean ready) {
    buttons.forEach(each -> each.setEnabled(ready));
  }

  /** What the focus belongs to: it changes nothing, or continues. */
  Component safeChoice() {
    return safeChoice;
  }

  Component text() {
    return text;
  }

  void focusText() {
    text.requestFocusInWindow();
  }

  private static SvgIcon icon(Severity severity) {
    return switch (severity) {
      case MESSAGE -> icon(Glyph.INFO);
      case WARNING -> Glyph.WARNING.icon(20, Palette.warning());
      case ERROR -> Glyph.ERROR.icon(20, Palette.error());
    };
  }

  private static SvgIcon icon(Glyph glyph) {
    return glyph.icon(20, Palette.accent());
  }
}
