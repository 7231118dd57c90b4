/** What came of mutation, for people and for viewers of reports. */
package org.pendant.testing.mutation.report;
