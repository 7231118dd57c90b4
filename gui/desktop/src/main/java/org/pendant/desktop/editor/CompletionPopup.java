package org.pendant.desktop.editor;

import static org.pendant.desktop.editor.EditorTexts.text;

import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.ListSelectionModel;
import javax.swing.SwingConstants;
import net.miginfocom.swing.MigLayout;
import org.pendant.desktop.editor.text.AnalysedText;
import org.pendant.desktop.editor.text.AnalysisSchedule;
import org.pendant.desktop.editor.text.Insertion;
import org.pendant.desktop.editor.text.RichText;
import org.pendant.desktop.editor.text.TextSpan;
import org.pendant.kit.background.WorkQueue;
import org.pendant.kit.layout.FloatingPanel;
import org.pendant.kit.theme.Palette;
import org.pendant.language.service.Completion;
import org.pendant.language.source.ByteText;

/**
 * Completion popup: offers what may be typed at the caret. The list is made on a worker thread for
 * the text as it is; while the next is being made the last one stays.
 */
final class CompletionPopup {
  private static final int ROWS = 10;
  private static final int GAP = 8;

  private final ScriptArea area;
  private final AnalysisSchedule schedule;
  private final WorkQueue background;
  private final JList<Completion> list = new JList<>();
  private final JLabel about = new JLabel();
  private final JPanel content = new JPanel(new MigLayout("insets 0, gap 0", "[330!][360!]"));
  private final FloatingPanel overlay;
  private final Runnable inserted;
  private int wordStart;
  private boolean inserting;

  /**
   * The completions of one text.
   *
   * @param inserted told when something was put into the text
   */
  CompletionPopup(
      ScriptArea area, AnalysisSchedule schedule, WorkQueue background, Runnable inserted) {
    this.area = area;
    this.schedule = schedule;
    this.background = background;
    this.inserted = inserted;
    list.setName("completions");
    list.getAccessibleContext().setAccessibleName(text("completions"));
    list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    list.setFocusable(false);
    list.setVisibleRowCount(ROWS);
    list.setCellRenderer(new CompletionCell());
    list.addListSelectionListener(event -> describe());
    about.setVerticalAlignment(SwingConstants.TOP);
    JScrollPane scroll = new JScrollPane(list);
    scroll.setBorder(BorderFactory.createEmptyBorder());
    scroll.setHorizontalScrollBarPolicy(JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
    content.add(scroll, "grow");
    content.add(about, "growx, top, gap 10 10 8 8");
    overlay = new FloatingPanel(area, content);
    area.addKeyListener(new Keys());
    area.addCaretListener(event -> caretMoved());
    list.addMouseListener(
        new MouseAdapter() {
          @Override
          public void mouseClicked(MouseEvent event) {
            if (event.getClickCount() == 2) {
              choose();
            }
          }
        });
  }

  boolean visible() {
    return overlay.visible();
  }

  void hide() {
    overlay.hide();
  }

  /** A character was typed: names and members are offered by themselves. */
  void typed(char c) {
    boolean word = Insertion.isWord(c) && !Character.isDigit(c);
    if (!visible() && (word || c == '.') && !schedule.isLong()) {
      request(false);
    }
  }

  /**
   * Offers what there is.
   *
   * @param asked whether the user asked for it; otherwise nothing is offered for a word that is
   *     complete
   */
  void request(boolean asked) {
    if (asked) {
      schedule.whenCurrent(analysed -> find(analysed, true));
    } else {
      schedule.whenDue(analysed -> find(analysed, false));
    }
  }

  private void find(AnalysedText analysed, boolean asked) {
    int caret = area.getCaretPosition();
    background.run(
        0,
        () -> {
          List<Completion> found = analysed.completions(caret);
          EventQueue.invokeLater(() -> offer(analysed, caret, found, asked));
        });
  }

  private void offer(AnalysedText analysed, int caret, List<Completion> found, boolean asked) {
    boolean outdated = schedule.current().filter(now -> now == analysed).isEmpty();
    if (outdated || caret != area.getCaretPosition() || !area.isShowing()) {
      return;
    }
    int start = wordStart(caret);
    String word = analysed.text().substring(start, caret);
    boolean wanted = asked || !word.isEmpty() || isBehindDot(analysed, start);
    if (!wanted || found.isEmpty() || (!asked && isComplete(found.getFirst(), word))) {
      hide();
      return;
    }
    wordStart = start;
    list.setListData(found.toArray(new Completion[0]));
    list.setPrototypeCellValue(found.getFirst());
    list.setSelectedIndex(0);
    list.setBackground(Palette.card());
    list.setSelectionBackground(Palette.tint(Palette.accent(), 0.24));
    list.setSelectionForeground(list.getForeground());
    list.setVisibleRowCount(Math.min(ROWS, found.size()));
    content.setOpaque(false);
    content.setPreferredSize(null);
    int rows = list.getPreferredScrollableViewportSize().height;
    int sentences = about.getPreferredSize().height + 2 * GAP;
    int width = content.getPreferredSize().width;
    content.setPreferredSize(new Dimension(width, Math.max(rows, sentences)));
    overlay.show(area.place(start), false);
  }

  /** Members are offered before their first letter; a word that was taken back asks for nothing. */
  private static boolean isBehindDot(AnalysedText analysed, int start) {
    return start > 0 && analysed.text().charAt(start - 1) == '.';
  }

  /** Whether choosing it would change nothing. */
  private static boolean isComplete(Completion best, String word) {
    return best.insert().equals(word);
  }

  private int wordStart(int caret) {
    int line = area.line(area.lineAt(caret)).start();
    return line + Insertion.wordStart(area.text(new TextSpan(line, caret)), caret - line);
  }

  private void caretMoved() {
    if (!visible() || inserting) {
      return;
    }
    int caret = area.getCaretPosition();
    if (caret < wordStart || wordStart(caret) != wordStart) {
      hide();
    } else {
      request(false);
    }
  }

  private void describe() {
    Completion chosen = list.getSelectedValue();
    about.setText(chosen == null ? "" : RichText.of(chosen));
    about.setForeground(list.getForeground());
  }

  private void choose() {
    Completion chosen = list.getSelectedValue();
    hide();
    if (chosen == null) {
      return;
    }
    int caret = area.getCaretPosition();
    Insertion insertion = Insertion.withArguments(chosen, area.getText(), wordStart, caret);
    inserting = true;
    area.make(List.of(insertion.edit()));
    area.setCaretPosition(insertion.caret());
    if (!insertion.arguments().isEmpty()) {
      area.tabStops().begin(insertion.arguments());
    }
    inserting = false;
    inserted.run();
  }

  /** ENTER behind a word that is complete ends the line: the list may not have gone yet. */
  private boolean chooseUnlessComplete() {
    Completion chosen = list.getSelectedValue();
    int caret = area.getCaretPosition();
    String word = area.text(new TextSpan(Math.min(wordStart, caret), caret));
    if (chosen != null && !isComplete(chosen, word)) {
      choose();
      return true;
    }
    hide();
    return false;
  }

  private void move(int rows) {
    int size = list.getModel().getSize();
    int from = list.getSelectedIndex();
    int to = Math.abs(rows) == 1 ? Math.floorMod(from + rows, size) : from + rows;
    list.setSelectedIndex(Math.clamp(to, 0, size - 1));
    list.ensureIndexIsVisible(list.getSelectedIndex());
  }

  /** The name that is chosen now, for tests and screen readers. */
  String chosen() {
    Completion chosen = list.getSelectedValue();
    return visible() && chosen != null ? ByteText.decoded(chosen.label()) : "";
  }

  /** The keys that belong to the list while it is there. */
  private final class Keys extends KeyAdapter {
    @Override
    public void keyPressed(KeyEvent event) {
      if (!visible() || event.isControlDown() || event.isAltDown()) {
        return;
      }
      boolean taken = true;
      switch (event.getKeyCode()) {
        case KeyEvent.VK_DOWN -> move(1);
        case KeyEvent.VK_UP -> move(-1);
        case KeyEvent.VK_PAGE_DOWN -> move(ROWS - 1);
        case KeyEvent.VK_PAGE_UP -> move(1 - ROWS);
        case KeyEvent.VK_ENTER -> taken = chooseUnlessComplete();
        case KeyEvent.VK_TAB -> choose();
        case KeyEvent.VK_ESCAPE -> hide();
        default -> taken = false;
      }
      if (taken) {
        event.consume();
      }
    }
  }
}
