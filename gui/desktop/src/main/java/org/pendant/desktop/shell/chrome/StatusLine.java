package org.pendant.desktop.shell.chrome;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.time.LocalTime;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Locale;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.Timer;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.Pace;
import org.pendant.controller.WallClock.Lateness;
import org.pendant.kit.fault.Faults;
import org.pendant.kit.theme.Markup;
import org.pendant.kit.theme.Palette;
import org.pendant.models.time.FrameTime;

/**
 * Status line: what was told last, for a while, with what was told before behind a button; and
 * whether robot time keeps its pace.
 */
@SuppressWarnings("serial") // never written to a stream
public final class StatusLine extends JPanel {
  /** How long a notice stands here. */
  private static final int FADES_MS = 8_000;

  private static final String UNDER_WAY = "\u2026";
  private static final int MAX_HISTORY = 20;
  private static final DateTimeFormatter TIME =
      DateTimeFormatter.ofPattern("HH:mm:ss", Locale.ROOT);

  /** Calls between two looks at the pace. */
  private static final int REFRESHES = 60;

  /** A share of its pace that robot time may miss without anybody being bothered. */
  private static final double KEPT = 0.95;

  private final JLabel told = new JLabel(" ");
  private final JButton whole = new JButton(ChromeTexts.text("more"));
  private final JButton earlier = new JButton("\u25b4");
  private final Consumer<String> showWhole;
  private final JButton punctual = new JButton();
  private final Timer fading = Faults.timer(FADES_MS, () -> show(""));
  private final Deque<String> history = new ArrayDeque<>();
  private long frames;
  private long sinceNs;
  private boolean wasHeld = true;
  private Pace lastPace = Pace.REAL_TIME;
  private int calls;
  private String last = "";
  private String explanation = "";
  private BooleanSupplier holds = () -> true;
  private Consumer<String> alsoTold = text -> {};

  /**
   * Nothing was told yet.
   *
   * @param showWhole shows a notice that is cut off here as a whole
   */
  public StatusLine(Consumer<String> showWhole) {
    super(
        new MigLayout(
            "insets 2 12 2 12, gap 16, hidemode 3", "[]8[0::, fill]8[][grow][right]", "[center]"));
    told.setName("status-text");
    told.getAccessibleContext().setAccessibleName(ChromeTexts.text("lastNotice"));
    punctual.setName("status-frames");
    punctual.getAccessibleContext().setAccessibleName(ChromeTexts.text("paceOfRobotTime"));
    punctual.putClientProperty("JButton.buttonType", "toolBarButton");
    punctual.putClientProperty("FlatLaf.style", "margin: 0,4,0,4");
    punctual.setVisible(false);
    punctual.addActionListener(event -> showWhole.accept(explanation));
    // Words about the pace take room from the notice.
    punctual.addPropertyChangeListener("text", event -> fit());
    whole.setName("status-more");
    whole.setVisible(false);
    whole.setToolTipText(ChromeTexts.text("showsTheNoticeAsAWhole"));
    whole.getAccessibleContext().setAccessibleName(ChromeTexts.text("showTheNoticeAsAWhole"));
    whole.putClientProperty("JButton.buttonType", "toolBarButton");
    whole.putClientProperty("FlatLaf.style", "margin: 0,4,0,4");
    whole.addActionListener(event -> showWhole.accept(text()));
    this.showWhole = showWhole;
    fading.setRepeats(false);
    earlier.setName("status-earlier");
    earlier.setVisible(false);
    earlier.setToolTipText(ChromeTexts.text("whatWasToldBefore"));
    earlier.getAccessibleContext().setAccessibleName(ChromeTexts.text("whatWasToldBefore"));
    earlier.putClientProperty("JButton.buttonType", "toolBarButton");
    earlier.putClientProperty("FlatLaf.style", "margin: 0,4,0,4");
    earlier.addActionListener(event -> showEarlier());
    // who looks at what was told before goes on where the keyboard was
    earlier.setRequestFocusEnabled(false);
    // It keeps its room while it is hidden: with the first notice nothing else moves.
    add(earlier, "hidemode 0");
    add(told, "growx, wmin 0");
    add(whole);
    add(punctual, "cell 4 0, wmin pref");
    addComponentListener(
        new ComponentAdapter() {
          @Override
          public void componentResized(ComponentEvent event) {
            fit();
          }
        });
  }

  /**
   * Shows a sentence for eight seconds, or until the next one; until that one if an ellipsis at its
   * end says that something is under way.
   */
  public void tell(String text) {
    tell(text, () -> true);
  }

  /** As the other one, and as long as {@code stillHolds} says that it is so. */
  public void tell(String text, BooleanSupplier stillHolds) {
    holds = stillHolds;
    show(text);
    if (!text.isBlank()) {
      history.addFirst(TIME.format(LocalTime.now(ZoneId.systemDefault())) + "  " + text);
      if (history.size() > MAX_HISTORY) {
        history.removeLast();
      }
      last = text;
      earlier.setVisible(true);
      fading.stop();
      if (!text.endsWith(UNDER_WAY)) {
        fading.start();
      }
    }
    alsoTold.accept(text);
  }

  /** Whether what stands there goes by itself. */
  boolean fades() {
    return fading.isRunning();
  }

  private void show(String text) {
    told.setText(text.isEmpty() ? " " : text);
    told.setToolTipText(text.isEmpty() ? null : text);
    fit();
  }

  private void showEarlier() {
    JPopupMenu menu = earlierNotices();
    menu.show(earlier, 0, -menu.getPreferredSize().height);
  }

  /** What was told, newest first, no wider than the window: a click shows the whole. */
  JPopupMenu earlierNotices() {
    JPopupMenu menu = new JPopupMenu();
    menu.setName("status-history");
    history.forEach(
        each -> {
          JMenuItem item = new JMenuItem(each);
          item.addActionListener(event -> showWhole.accept(each));
          Dimension whole = item.getPreferredSize();
          item.setPreferredSize(new Dimension(Math.min(whole.width, getWidth()), whole.height));
          menu.add(item);
        });
    return menu;
  }

  /** Has {@code listener} hear from now on what is told. */
  public void alsoTell(Consumer<String> listener) {
    alsoTold = listener;
  }

  /** The last notice, which may have faded since; empty if there was none. */
  public String text() {
    return last;
  }

  /** Offers to show the whole where a part of it is cut off. */
  private void fit() {
    int others = punctual.getPreferredSize().width + UIScale.scale(60);
    whole.setVisible(told.getPreferredSize().width + others > getWidth());
  }

  /**
   * Takes back a sentence that no longer holds, and shows whether robot time keeps its pace; called
   * 30 times a second.
   *
   * @param pace what robot time should keep
   * @param behindS by how much robot time has fallen behind the wall clock, s
   * @param held whether a debugger has paused the program
   */
  public void refresh(Lateness lateness, Pace pace, double behindS, boolean held) {
    if (!holds.getAsBoolean()) {
      holds = () -> true;
      show("");
    }
    calls++;
    if (calls % REFRESHES != 1) {
      return;
    }
    long now = System.nanoTime();
    double passedS = (now - sinceNs) / 1e9;
    // Frames are not due while a debugger holds them, nor right after that.
    boolean due = !held && !wasHeld && pace.equals(lastPace);
    punctual.setForeground(Palette.warning());
    showPace(
        due ? text(pace, lateness.frames() - frames, passedS) : "", explanation(lateness, behindS));
    frames = lateness.frames();
    sinceNs = now;
    wasHeld = held;
    lastPace = pace;
  }

  /** Says how robot time keeps its pace; {@code behind} is what a click shows. */
  void showPace(String words, String behind) {
    explanation = behind;
    punctual.setText(words);
    punctual.setToolTipText(Markup.toolTip(behind));
    punctual.setVisible(!words.isEmpty());
  }

  /** What is behind the words. */
  static String explanation(Lateness lateness, double behindS) {
    return String.format(
        Locale.ROOT,
        ChromeTexts.text("computerIsBusy"),
        lateness.frames() > 0 ? 100.0 * lateness.lateFrames() / lateness.frames() : 0,
        lateness.worstNs() / 1e6,
        behindS);
  }

  /** What is to say of so many frames in so much time: nothing while robot time keeps its pace. */
  static String text(Pace pace, long frames, double passedS) {
    if (!(pace instanceof Pace.Times(double factor)) || frames <= 0) {
      return "";
    }
    double share = frames * FrameTime.FRAME_S / (passedS * factor);
    if (share >= KEPT) {
      return "";
    }
    return String.format(
        Locale.ROOT,
        pace.equals(Pace.REAL_TIME)
            ? ChromeTexts.text("shareOfRealTime")
            : ChromeTexts.text("shareOfItsPace"),
        Math.floor(100 * share));
  }
}
