# SPDX-License-Identifier: Apache-2.0
from setuptools import setup

NAME = "filter_report"

setup(
    name=NAME,
    version="1.0.0",
    packages=[NAME],
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/" + NAME]),
        ("share/" + NAME, ["package.xml"]),
    ],
    install_requires=["setuptools"],
    zip_safe=True,
    maintainer="The ros2_filter authors",
    maintainer_email="ros2_filter@example.org",
    description="Feeds a noisy sine to filter_core and reports how much of the noise is left",
    license="Apache-2.0",
    entry_points={"console_scripts": ["filter_report = filter_report.report:main"]},
)
