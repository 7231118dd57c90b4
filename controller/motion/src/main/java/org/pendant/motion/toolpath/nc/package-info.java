/**
 * Toolpath files (.nc) in the dialect of the manual's sample (manual 20.12). Open {@link
 * org.pendant.motion.toolpath.nc.NcReader} first.
 */
package org.pendant.motion.toolpath.nc;
