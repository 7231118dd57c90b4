package org.pendant.desktop.help;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

final class HelpSearchTest {
  private static final HelpPage MOTION = new HelpPage("motion.md", "Motion");
  private static final HelpPage SAFETY = new HelpPage("safety.md", "Safety");

  private final HelpSearch search =
      new HelpSearch(
          List.of(MOTION, SAFETY),
          Map.of(
                  MOTION,
                  "# Motion\n\nHow arms move.\n\n## Blend radius\n\nCorners, *and* stops.\n",
                  SAFETY,
                  """
                  # Safety

                  | limit | unit |
                  |---|---|
                  | radius | m |

                  ## Stops

                  A corner.
                  """)
              ::get);

  private List<String> find(String query) {
    return search.find(query).stream().map(HelpSearch.Hit::toString).toList();
  }

  @Test
  void aSectionIsFoundByItsHeadingFirstAndThenByItsText() {
    assertEquals(List.of("Motion: Blend radius", "Safety"), find("radius"));
    assertEquals(List.of("Safety: Stops", "Motion: Blend radius"), find("STOPS"));
  }

  @Test
  void allWordsMustBeThere() {
    assertEquals(List.of("Motion: Blend radius"), find("  corners blend "));
    assertEquals(List.of(), find("corners limit"));
  }

  @Test
  void aHitLeadsToItsPlaceAsThePageHasIt() {
    assertEquals("blend-radius", search.find("blend").getFirst().place());
  }

  @Test
  void placesAreThoseOfTheHeadingsOfEveryPageOfTheHelp() {
    for (HelpPage page : HelpPage.all()) {
      String text = HelpTexts.find(page.name()).orElse("");
      String html = Markdown.html(text);
      for (HelpSearch.Hit hit : new HelpSearch(List.of(page), each -> text).find("")) {
        assertTrue(
            hit.place().isEmpty() || html.contains("id=\"" + hit.place() + "\""), hit.toString());
      }
    }
  }
}
