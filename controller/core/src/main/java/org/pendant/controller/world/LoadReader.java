package org.pendant.controller.world;

import static org.pendant.controller.world.WorldTexts.text;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.pendant.language.check.Nearest;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.Range;

/** Load reader: reads the load of a scene: what is truly mounted on the flange. */
public final class LoadReader {
  /** Several times what the strongest arm carries. */
  private static final Range MASS = new Range(0, 100, "kg");

  private static final Range CENTRE_OF_GRAVITY = new Range(-4, 4, "m");

  /** As set_target_payload allows (manual 16.52). */
  private static final Range MOMENT = new Range(0, 133, "kg m\u00b2");

  /** As set_target_payload allows (manual 16.52). */
  private static final Range PRODUCT = new Range(-133, 133, "kg m\u00b2");

  /** Share of the moments of inertia that rounding in a file may do: numbers of four digits. */
  private static final double ROUNDING = 1e-4;

  private LoadReader() {}

  public static Payload load(Json value) throws JsonException {
    JsonFields fields = new JsonFields(value, text("aLoad"));
    fields.allow(Nearest::among, "mass", "cog", "inertia");
    double massKg = fields.number("mass", MASS);
    Vector3 cogM =
        fields.optional("cog").isPresent()
            ? Vector3.read(fields, "cog", CENTRE_OF_GRAVITY)
            : new Vector3(0, 0, 0);
    Optional<Json> inertia = fields.optional("inertia");
    if (inertia.isEmpty()) {
      return Payload.of(massKg, cogM.x(), cogM.y(), cogM.z());
    }
    List<Json> six = fields.numbers("inertia", 6);
    double[] i = new double[6];
    for (int k = 0; k < i.length; k++) {
      i[k] = JsonFields.number("inertia[" + k + "]", six.get(k), k < 3 ? MOMENT : PRODUCT);
    }
    if (!possible(i[0], i[1], i[2], i[3], i[4], i[5])) {
      throw inertia.get().place().refusal(text("impossibleInertia", Arrays.toString(i)));
    }
    return new Payload(massKg, cogM.x(), cogM.y(), cogM.z(), i[0], i[1], i[2], i[3], i[4], i[5]);
  }

  /**
   * Whether a body can have these moments and products: the integral of {@code r r^T dm}, which is
   * half the trace of the inertia minus the inertia, has no negative eigenvalue. (All principal
   * minors of a symmetric matrix tell that.)
   */
  private static boolean possible(
      double ixx, double iyy, double izz, double ixy, double ixz, double iyz) {
    double trace = ixx + iyy + izz;
    double slack = ROUNDING * trace;
    double xx = trace / 2 - ixx + slack;
    double yy = trace / 2 - iyy + slack;
    double zz = trace / 2 - izz + slack;
    double determinant =
        xx * yy * zz - 2 * ixy * ixz * iyz - xx * iyz * iyz - yy * ixz * ixz - zz * ixy * ixy;
    return xx >= 0
        && yy >= 0
        && zz >= 0
        && xx * yy >= ixy * ixy
        && xx * zz >= ixz * ixz
        && yy * zz >= iyz * iyz
        && determinant >= 0;
  }
}
