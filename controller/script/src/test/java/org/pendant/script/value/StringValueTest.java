package org.pendant.script.value;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Strings that grow piece by piece. */
class StringValueTest {
  private static final StringValue LONG = new StringValue("0123456789".repeat(10));

  @Test
  void twoStringsMadeFromOneDoNotSeeEachOther() {
    StringValue base = LONG.followedBy(new StringValue("-"));
    StringValue first = base.followedBy(new StringValue("first"));
    StringValue second = base.followedBy(new StringValue("second"));

    assertEquals("0123456789".repeat(10) + "-", base.bytes());
    assertEquals(base.bytes() + "first", first.bytes());
    assertEquals(base.bytes() + "second", second.bytes());
    assertNotEquals(first, second);
  }

  @Test
  void aStringCanBeAddedToItself() {
    StringValue base = LONG.followedBy(new StringValue("x"));

    assertEquals(base.bytes().repeat(2), base.followedBy(base).bytes());
  }

  @Test
  void anEmptyTailChangesNothing() {
    StringValue base = LONG.followedBy(new StringValue(""));

    assertEquals(LONG, base.followedBy(new StringValue("")));
  }

  @Test
  void randomTreesOfAdditionsEqualPlainStrings() {
    for (long seed = 0; seed < 200; seed++) {
      Random random = new Random(seed);
      List<StringValue> values = new ArrayList<>(List.of(new StringValue("a"), LONG));
      List<String> plain = new ArrayList<>(List.of("a", LONG.bytes()));
      for (int i = 0; i < 30; i++) {
        int left = random.nextInt(values.size());
        int right = random.nextInt(Math.min(4, values.size()));
        values.add(values.get(left).followedBy(values.get(right)));
        plain.add(plain.get(left) + plain.get(right));
      }
      for (int i = 0; i < plain.size(); i++) {
        assertEquals(plain.get(i), values.get(i).bytes(), "seed " + seed + ", value " + i);
      }
    }
  }
}
