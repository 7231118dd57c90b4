package org.pendant.kit.theme;

import com.formdev.flatlaf.extras.FlatAnimatedLafChange;
import java.awt.GraphicsEnvironment;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import javax.swing.Timer;
import org.pendant.kit.fault.Faults;

/**
 * Curtain: a picture of the windows as they were, in front of them until all that is behind it has
 * the new colours. Parts that are drawn on other threads need a moment for that, and windows half
 * in the old and half in the new colours flicker. Only the dispatch thread calls it.
 */
final class Curtain {
  private static final int LOOK_MS = 15;

  /** Whoever changes the colours does not wait longer to see some. */
  private static final int MAX_LOOKS = 30;

  private final List<BooleanSupplier> parts = new ArrayList<>();
  private final Timer timer = Faults.timer(LOOK_MS, this::look);
  private int looks;

  /** Waits for {@code part}, too. */
  void awaits(BooleanSupplier part) {
    parts.add(part);
  }

  /** Keeps what is seen as it is. */
  void drop() {
    if (!parts.isEmpty() && !GraphicsEnvironment.isHeadless()) {
      FlatAnimatedLafChange.stop();
      FlatAnimatedLafChange.showSnapshot();
    }
  }

  /** Shows the windows as soon as every part is ready, after {@link #MAX_LOOKS} anyway. */
  void lift() {
    looks = 0;
    if (!parts.isEmpty()) {
      timer.restart();
    }
  }

  private void look() {
    looks++;
    if (looks >= MAX_LOOKS || parts.stream().allMatch(BooleanSupplier::getAsBoolean)) {
      timer.stop();
      FlatAnimatedLafChange.stop();
    }
  }
}
