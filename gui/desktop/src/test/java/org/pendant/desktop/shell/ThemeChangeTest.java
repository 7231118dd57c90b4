package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.Color;
import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import javax.swing.AbstractButton;
import javax.swing.JLabel;
import javax.swing.UIDefaults;
import javax.swing.UIManager;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.ControllerOptions;
import org.pendant.desktop.help.Example;
import org.pendant.desktop.session.OpenFiles;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.RecoveryFolder;
import org.pendant.desktop.session.RobotSession;
import org.pendant.kit.settings.FileSettings;
import org.pendant.kit.theme.Look;
import org.pendant.kit.theme.Theme;

/**
 * The colours of everything in the window after a change of the theme, where there is a display.
 */
@Tag("slow")
final class ThemeChangeTest {
  @TempDir Path folder;

  private RobotSession session;
  private Look look;
  private DesktopWindow window;

  /** Colours that the look has in one theme alone. */
  private final Map<Theme, Set<Integer>> own = new EnumMap<>(Theme.class);

  @Test
  @Timeout(value = 300, unit = TimeUnit.SECONDS)
  void nothingKeepsTheColoursOfTheOtherTheme() throws Exception {
    assumeFalse(GraphicsEnvironment.isHeadless(), "there is no display to open a window on");
    session = RobotSession.start(ControllerOptions.headless());
    try {
      EventQueue.invokeAndWait(this::make);
      for (String view : window.views()) {
        EventQueue.invokeAndWait(() -> window.show(view));
      }
      for (Theme theme : List.of(Theme.DARK, Theme.LIGHT)) {
        Set<String> wrong = new TreeSet<>();
        EventQueue.invokeAndWait(
            () -> {
              look.setTheme(theme);
              window.refreshAll();
            });
        for (String view : window.views()) {
          EventQueue.invokeAndWait(
              () -> {
                window.show(view);
                wrong.addAll(wrong(theme));
              });
        }
        assertEquals(Set.of(), wrong, "after a change to " + theme.word());
      }
    } finally {
      EventQueue.invokeAndWait(window::dispose);
      session.close();
    }
  }

  private void make() {
    FileSettings settings = FileSettings.open(folder.resolve("settings.txt"));
    look = new Look(settings);
    look.install();
    look.setTheme(Theme.DARK);
    Set<Integer> dark = colours();
    look.setTheme(Theme.LIGHT);
    Set<Integer> light = colours();
    own.put(Theme.DARK, without(dark, light));
    own.put(Theme.LIGHT, without(light, dark));
    Example first = Example.all().getFirst();
    window =
        new DesktopWindow(
            new WindowFrame(settings),
            session,
            settings,
            look,
            new Programs(ProgramDocument.untitled(first.file(), first.text())),
            new RecoveryFolder(folder.resolve("recovery")),
            new OpenFiles(folder.resolve("windows")),
            settings::close);
    window.frame().setSize(1440, 900);
    window.frame().addNotify();
  }

  private static Set<Integer> without(Set<Integer> all, Set<Integer> others) {
    Set<Integer> left = new HashSet<>(all);
    left.removeAll(others);
    return left;
  }

  private static Set<Integer> colours() {
    UIDefaults defaults = UIManager.getLookAndFeelDefaults();
    Set<Integer> all = new HashSet<>();
    for (Object key : defaults.keySet().toArray()) {
      if (defaults.get(key) instanceof Color color) {
        all.add(color.getRGB());
      }
    }
    return all;
  }

  private List<String> wrong(Theme theme) {
    Set<Integer> others = own.get(theme == Theme.DARK ? Theme.LIGHT : Theme.DARK);
    List<String> wrong = new ArrayList<>();
    // That of the window itself stays, as WindowBackgrounds says; none of it is seen.
    collect(window.frame().getRootPane(), others, wrong);
    return wrong;
  }

  private static void collect(Component component, Set<Integer> others, List<String> wrong) {
    if (others.contains(component.getForeground().getRGB())) {
      wrong.add("text of " + place(component));
    }
    if (others.contains(component.getBackground().getRGB())) {
      wrong.add("background of " + place(component));
    }
    if (component instanceof Container container) {
      for (Component each : container.getComponents()) {
        collect(each, others, wrong);
      }
    }
  }

  private static String place(Component component) {
    List<String> names = new ArrayList<>();
    for (Component each = component; each != null; each = each.getParent()) {
      names.add(each.getName() == null ? each.getClass().getSimpleName() : each.getName());
    }
    String text =
        switch (component) {
          case JLabel label -> label.getText();
          case AbstractButton button -> button.getText();
          default -> "";
        };
    return "'" + text + "' " + String.join(" in ", names.subList(0, Math.min(4, names.size())));
  }
}
