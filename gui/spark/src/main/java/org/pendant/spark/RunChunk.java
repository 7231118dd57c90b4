package org.pendant.spark;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import org.apache.spark.TaskContext;
import org.apache.spark.api.java.function.Function;
import org.apache.spark.broadcast.Broadcast;
import org.pendant.sweep.remote.ResultCodec;
import org.pendant.sweep.run.SweepJob;

/** What a worker does: runs the variants of a chunk, and answers with the results of all. */
final class RunChunk implements Function<byte[], byte[]> {
  private static final long serialVersionUID = 1L;

  private final Broadcast<WorkerJob> job;

  RunChunk(Broadcast<WorkerJob> job) {
    this.job = job;
  }

  @Override
  public byte[] call(byte[] chunk) throws IOException {
    SweepJob read = job.value().job();
    long startNs = System.nanoTime();
    DataInputStream in = new DataInputStream(new ByteArrayInputStream(chunk));
    ByteArrayOutputStream results = new ByteArrayOutputStream();
    DataOutputStream out = new DataOutputStream(results);
    int size = in.readInt();
    for (int i = 0; i < size; i++) {
      // Spark asks a task to end when a faster copy of it has, or when the sweep ends early.
      TaskContext.get().killTaskIfInterrupted();
      ResultCodec.write(out, read.run(ResultCodec.readVariant(in)));
    }
    out.writeLong(System.nanoTime() - startNs);
    return results.toByteArray();
  }
}
