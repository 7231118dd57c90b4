/** Parameters of an arm from recordings of its motion, by linear least squares. */
package org.pendant.models.identification;
