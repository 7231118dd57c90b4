package org.pendant.kit.action;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.formdev.flatlaf.FlatLightLaf;
import java.util.concurrent.atomic.AtomicBoolean;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenuItem;
import javax.swing.JRadioButtonMenuItem;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.pendant.kit.dispatch.OnDispatchThread;
import org.pendant.kit.settings.MemorySettings;

@OnDispatchThread
final class ActionItemTest {
  private final ActionTable actions = new ActionTable(new MemorySettings());

  /** Remembers nothing. */
  @BeforeAll
  static void look() {
    FlatLightLaf.setup();
  }

  @Test
  void whatIsOnHasAMark() {
    AtomicBoolean on = new AtomicBoolean(true);
    actions.add(Action.of("noise", "Noise", "", () -> on.set(!on.get())).checked(on::get));
    JMenuItem item = ActionItem.of(actions, "noise");
    assertInstanceOf(JCheckBoxMenuItem.class, item);
    assertTrue(item.isSelected());
    item.doClick();
    assertFalse(ActionItem.of(actions, "noise").isSelected());
  }

  @Test
  void oneOfSeveralHasAnotherMark() {
    actions.add(Action.of("dark", "Colours: Dark", "", () -> {}).chosen(() -> false));
    JMenuItem item = ActionItem.of(actions, "dark");
    assertInstanceOf(JRadioButtonMenuItem.class, item);
    assertFalse(item.isSelected());
  }

  @Test
  void titleGoesWithoutWhatItsMenuSays() {
    actions.add(Action.of("fit", "3D: show the whole robot", "", () -> {}));
    assertEquals("Show the whole robot", ActionItem.of(actions, "fit", "3D").getText());
    assertEquals("3D: show the whole robot", ActionItem.of(actions, "fit", "Log").getText());
  }
}
