package org.pendant.desktop.tests;

import static org.pendant.desktop.tests.TestsTexts.text;

import java.awt.BorderLayout;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import org.pendant.command.service.GoldenComparison;
import org.pendant.kit.layout.WrappingRow;
import org.pendant.kit.theme.Palette;
import org.pendant.recording.compare.TrackCurves;
import org.pendant.testing.TestId;

/**
 * Golden card: how a test differs from its recording, and what takes the new run in its place. It
 * asks before a recording is replaced.
 */
@SuppressWarnings("serial") // never written to a stream
final class GoldenCard extends JPanel {
  private final GoldenPlot plot = new GoldenPlot();
  private final JLabel question = new JLabel(text("replaceTheRecording"));
  private final JButton accept = new JButton(text("acceptAsGolden"));
  private final JButton replace = new JButton(text("replace"));
  private final JButton keep = new JButton(text("keep"));
  private final Runnable record;
  private Optional<TestId> test = Optional.empty();
  private GoldenOffer offer = GoldenOffer.NONE;
  private boolean asking;
  private boolean enabled;

  /**
   * A card that shows nothing yet.
   *
   * @param record records the test that is shown anew
   */
  GoldenCard(Runnable record) {
    super(new BorderLayout());
    this.record = record;
    setName("tests-golden");
    setBorder(BorderFactory.createMatteBorder(0, 1, 0, 0, Palette.line()));
    JPanel row = new JPanel(new WrappingRow(6));
    accept.setName("tests-accept");
    replace.setName("tests-replace");
    keep.setName("tests-keep");
    row.add(accept);
    row.add(question);
    row.add(replace);
    row.add(keep);
    add(plot);
    add(row, BorderLayout.SOUTH);
    accept.addActionListener(event -> accept());
    replace.addActionListener(event -> take());
    keep.addActionListener(event -> ask(false));
    setVisible(false);
  }

  /**
   * Shows a test.
   *
   * @param canRun whether tests can run now
   */
  void show(Optional<TestId> id, GoldenOffer of, Optional<TrackCurves> curves, boolean canRun) {
    boolean other = !id.equals(test) || of != offer;
    test = id;
    offer = of;
    enabled = canRun;
    setVisible(of != GoldenOffer.NONE);
    plot.setVisible(curves.isPresent());
    curves.ifPresent(plot::show);
    id.map(GoldenComparison::name)
        .ifPresent(name -> question.setToolTipText(text("getsWhatTheTestDoesNow", name)));
    accept.setText(of == GoldenOffer.RECORD ? text("recordAsGolden") : text("acceptAsGolden"));
    accept.setToolTipText(
        of == GoldenOffer.RECORD
            ? text("runsTheTestAndRecordsWhat")
            : text("runsTheTestAgainAndTakes"));
    ask(asking && !other);
  }

  /** Whether the new run can be taken. */
  boolean offers() {
    return offer != GoldenOffer.NONE && enabled;
  }

  /** Takes the new run, after a question where that replaces a recording. */
  void accept() {
    if (!offers()) {
      return;
    }
    if (offer == GoldenOffer.RECORD) {
      take();
    } else {
      ask(true);
      keep.requestFocusInWindow();
    }
  }

  private void take() {
    ask(false);
    record.run();
  }

  private void ask(boolean wanted) {
    boolean back = asking && !wanted && (keep.isFocusOwner() || replace.isFocusOwner());
    asking = wanted;
    accept.setVisible(!wanted);
    accept.setEnabled(enabled);
    question.setVisible(wanted);
    replace.setVisible(wanted);
    replace.setEnabled(enabled);
    keep.setVisible(wanted);
    if (back) {
      accept.requestFocusInWindow();
    }
  }
}
