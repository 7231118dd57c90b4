package org.pendant.kit.form;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JScrollPane;
import org.junit.jupiter.api.Test;
import org.pendant.kit.dispatch.OnDispatchThread;

@OnDispatchThread
final class ItemsTest {
  private final List<String> kept = new ArrayList<>();
  private final Items<String> items =
      new Items<>(
          "planes",
          "Planes",
          "No plane.",
          new Items.Model<>() {
            @Override
            public List<String> list() {
              return List.copyOf(kept);
            }

            @Override
            public String refusal(List<String> next) {
              return "";
            }

            @Override
            public void take(List<String> next, Optional<String> before, Optional<String> after) {
              kept.clear();
              kept.addAll(next);
            }
          },
          name -> name);

  private int listHeight() {
    return Stream.of(items.component().getComponents())
        .filter(JScrollPane.class::isInstance)
        .mapToInt(each -> each.getPreferredSize().height)
        .findFirst()
        .orElseThrow();
  }

  @Test
  void theListIsAsHighEmptyAsWithItems() {
    FlatLaf.setup(new FlatLightLaf());
    Items<String> shown = items;
    shown.show();
    int empty = listHeight();
    kept.add("Plane_1");
    shown.show();
    assertEquals(listHeight(), empty);
  }
}
