package org.pendant.spark;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import org.pendant.sweep.plan.SweepVariant;
import org.pendant.sweep.remote.ResultCodec;
import org.pendant.sweep.run.SweepResult;

/**
 * Chunk: variants that one task of Spark runs, one after the other.
 *
 * @param variants in the order of their numbers
 */
record Chunk(List<SweepVariant> variants) {
  Chunk {
    variants = List.copyOf(variants);
  }

  /** Results of a chunk, and how long it took. */
  record Results(List<SweepResult> results, long durationNs) {
    Results {
      results = List.copyOf(results);
    }
  }

  /** For {@link RunChunk}. */
  byte[] bytes() {
    try {
      ByteArrayOutputStream bytes = new ByteArrayOutputStream();
      DataOutputStream out = new DataOutputStream(bytes);
      out.writeInt(variants.size());
      for (SweepVariant each : variants) {
        ResultCodec.write(out, each);
      }
      return bytes.toByteArray();
    } catch (IOException e) {
      throw new UncheckedIOException("memory does not fail", e);
    }
  }

  /** What {@link RunChunk} answered. */
  Results results(byte[] answer) throws IOException {
    DataInputStream in = new DataInputStream(new ByteArrayInputStream(answer));
    List<SweepResult> results = new ArrayList<>();
    for (SweepVariant each : variants) {
      results.add(ResultCodec.readResult(in, each));
    }
    return new Results(results, in.readLong());
  }
}
