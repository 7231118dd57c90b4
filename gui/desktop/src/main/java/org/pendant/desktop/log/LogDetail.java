package org.pendant.desktop.log;

import static org.pendant.desktop.log.LogTexts.text;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Insets;
import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.text.Messages;
import org.pendant.language.source.ByteText;

/** Log detail: one message in full, wrapped and selectable. */
final class LogDetail {
  /** Lines that can be seen at least, the headline among them. */
  private static final int MIN_LINES = 3;

  private final JPanel content = new Lower();
  private final JLabel heading = new JLabel();
  private final JButton source = new JButton();
  private final JTextArea text = new JTextArea();
  private final LogRuns runs;
  private final LogHighlights highlights = new LogHighlights(text);
  private Optional<LogLine> shown = Optional.empty();

  /** Nothing is shown yet; {@code runs} say where messages come from. */
  LogDetail(LogRuns runs, Consumer<LogLine> showSource) {
    this.runs = runs;
    JPanel head =
        new JPanel(new MigLayout("insets 4 8 4 8, gap 8", "[grow, 0::, fill][]", "[28:pref:]"));
    heading.setForeground(LogColors.quiet());
    head.add(heading, "wmin 0");
    head.add(source, "hidemode 3");
    source.setName("log-show-source");
    source.putClientProperty("JButton.buttonType", "toolBarButton");
    source.addActionListener(event -> shown.ifPresent(showSource));
    text.setName("log-detail");
    text.putClientProperty("FlatLaf.styleClass", "monospaced");
    text.setEditable(false);
    text.setLineWrap(true);
    text.setWrapStyleWord(true);
    text.setMargin(new Insets(0, 8, 8, 8));
    text.setToolTipText(text("theWholeMessage"));
    text.getAccessibleContext().setAccessibleName(text("theWholeMessage"));
    JScrollPane scroll = new JScrollPane(text);
    scroll.setBorder(BorderFactory.createEmptyBorder());
    content.add(head, BorderLayout.NORTH);
    content.add(scroll, BorderLayout.CENTER);
    showNone();
  }

  JComponent component() {
    return content;
  }

  void show(LogLine line) {
    if (shown.isPresent() && shown.get().equals(line)) {
      return;
    }
    shown = Optional.of(line);
    heading.setText(headline(line));
    heading.setToolTipText(heading.getText());
    heading.setIcon(SeverityIcon.of(line.level()));
    text.setText(line.text() + help(line));
    highlights.show();
    text.setCaretPosition(0);
    source.setVisible(line.sourceLine().isPresent());
    if (line.sourceLine().isPresent()) {
      offerSource(runs.shortWords(line), runs.words(line));
    }
  }

  private String headline(LogLine line) {
    StringBuilder words = new StringBuilder();
    words.append(text("from", line.severity(), line.source().title(), line.timeText()));
    if (!line.wallText().isEmpty()) {
      words.append(" (").append(line.wallText()).append(')');
    }
    line.place()
        .ifPresent(
            at -> {
              String file = ByteText.decoded(fileName(at.source()));
              words.append(", ").append(text("place", line.thread(), runs.words(line), file));
            });
    if (!line.code().isEmpty()) {
      words.append(", ").append(line.code());
    }
    return words.toString();
  }

  private static String fileName(String source) {
    return source.substring(Math.max(source.lastIndexOf('/'), source.lastIndexOf('\\')) + 1);
  }

  /** What the code of a safety function means and what may help, below the message. */
  private static String help(LogLine line) {
    return CodeHelp.of(line.code())
        .map(help -> "\n\n" + Messages.told(line.code(), help.meaning()) + "\n" + help.suggestion())
        .orElse("");
  }

  /** Marks what is looked for. */
  void mark(TextSearch search) {
    highlights.mark(search);
  }

  private void offerSource(String brief, String place) {
    source.setText(text("goToPlace", brief));
    source.setToolTipText(text("showPlaceOfTheProgramEnter", place));
    source.getAccessibleContext().setAccessibleName(source.getText());
  }

  void showNone() {
    shown = Optional.empty();
    heading.setText(text("selectAMessageToReadAll"));
    heading.setIcon(null);
    text.setText("");
    source.setVisible(false);
  }

  void copy(String words) {
    Toolkit.getDefaultToolkit().getSystemClipboard().setContents(new StringSelection(words), null);
  }

  /** At least a few lines, but never most of what there is. */
  @SuppressWarnings("serial") // never written to a stream
  private static final class Lower extends JPanel {
    Lower() {
      super(new BorderLayout());
    }

    @Override
    public Dimension getMinimumSize() {
      int lines = MIN_LINES * getFontMetrics(getFont()).getHeight();
      int room = getParent() == null ? lines : getParent().getHeight();
      return new Dimension(0, Math.min(lines, room * 3 / 10));
    }
  }
}
