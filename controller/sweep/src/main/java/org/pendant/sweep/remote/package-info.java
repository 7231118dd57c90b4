/**
 * What engines whose workers are other processes send them: the files of a job, variants, results.
 * See {@link org.pendant.sweep.remote.JobArchive} first.
 */
package org.pendant.sweep.remote;
